/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface_history.h"

#include <string.h>

/* `other` of them all: after the walls of the box, -1 to -6. */
enum { SURFACE_SPRING = -7 };

int surface_history_list(struct surfaces *sf, const struct particles *ps,
                         struct dem_history *list)
{
    int n = 0;

    for (int s = 0; sf != NULL && s < sf->n_chunks; s++) {
        const struct surface_histories *const f =
            surfaces_contact_history(sf, s, ps);
        for (int q = 0; q < f->n; q++, n++) {
            if (list == NULL) continue;
            list[n].id = f->list[q].id;
            list[n].other = SURFACE_SPRING;
            memcpy(list[n].xi, f->list[q].xi, sizeof list[n].xi);
            memcpy(list[n].roll_angle, f->list[q].roll_angle,
                   sizeof list[n].roll_angle);
            memcpy(list[n].n, f->list[q].n, sizeof list[n].n);
        }
    }
    return n;
}

int surface_history_restore(struct surfaces *sf, const struct dem_history *list,
                            int n)
{
    int many = 0;

    if (sf != NULL) surfaces_clear_history(sf);
    while (many < n && list[n - many - 1].other == SURFACE_SPRING)
        many++;
    for (int q = n - many; q < n && sf != NULL; q++) {
        struct surface_history one = {.id = list[q].id};
        memcpy(one.n, list[q].n, sizeof one.n);
        memcpy(one.xi, list[q].xi, sizeof one.xi);
        memcpy(one.roll_angle, list[q].roll_angle, sizeof one.roll_angle);
        surfaces_restore_history(sf, &one);
    }
    return many;
}
