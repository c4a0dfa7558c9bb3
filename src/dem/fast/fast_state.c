/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/fast_internal.h"

#include "base/alloc.h"
#include "dem/surfaces/surface_history.h"

void fast_state(struct dem *dem, struct state *s)
{
    state_real(s, "min_margin", "m", &fast_of(dem)->min_margin);
    neighbours_state(fast_of(dem)->neighbours, s);
}

struct dem_history *fast_histories(struct dem *dem, int *n)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct particles *const ps = nb->history_given ? NULL : nb->ps;
    const int *const id = nb->ps->id;
    const struct contact_history *const kept =
        neighbours_contact_history(nb, n);
    const int more = surface_history_list(nb->surfaces, ps, NULL);
    struct dem_history *const list =
        alloc_zeroed((size_t)*n + (size_t)more, sizeof *list);

    for (int q = 0; q < *n; q++) {
        list[q].id = id[kept[q].owner];
        list[q].other =
            kept[q].partner < 0 ? kept[q].partner : id[kept[q].partner];
        for (int k = 0; k < 3; k++) {
            list[q].xi[k] = kept[q].xi[k];
            list[q].roll_angle[k] = kept[q].roll_angle[k];
        }
    }
    surface_history_list(nb->surfaces, ps, list + *n);
    *n += more;
    return list;
}

void fast_restore_histories(struct dem *dem, const struct dem_history *list,
                            int n, const int *index)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const int own = n - surface_history_restore(nb->surfaces, list, n);
    struct contact_history *const kept = neighbours_restore_history(nb, own);

    for (int q = 0; q < own; q++) {
        kept[q].owner = index[list[q].id];
        kept[q].partner =
            list[q].other < 0 ? list[q].other : index[list[q].other];
        for (int k = 0; k < 3; k++) {
            kept[q].xi[k] = list[q].xi[k];
            kept[q].roll_angle[k] = list[q].roll_angle[k];
        }
    }
}
