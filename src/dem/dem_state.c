/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/dem_internal.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/surfaces/surface_history.h"

void dem_clock(struct dem *dem, long steps)
{
    dem->motion_steps = steps;
    dem->motion_on = 1;
}

struct dem_surface dem_surface(const struct dem *dem, int k)
{
    const struct surface_received a =
        surfaces_received(dem->neighbours->surfaces, k);
    struct dem_surface r = {.work = a.work};

    r.pose = motion_pose(&dem->options.surfaces[k].motion,
                         (double)dem->motion_steps * dem->options.step);
    memcpy(r.impulse, a.impulse, sizeof r.impulse);
    memcpy(r.angular, a.angular, sizeof r.angular);
    return r;
}

struct dem_spring *dem_springs(struct dem *dem, int *n)
{
    struct neighbours *const nb = dem->neighbours;
    const struct particles *const ps = nb->history_given ? NULL : nb->ps;
    const int *const id = nb->ps->id;
    const struct contact_history *const kept =
        neighbours_contact_history(nb, n);
    const int more = surface_history_list(nb->surfaces, ps, NULL);
    struct dem_spring *const list =
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

/* The index of each id; -1: there is no such particle. */
static int *places(const struct particles *ps)
{
    int *const place = alloc_ints(ps->next_id);

    for (int id = 0; id < ps->next_id; id++)
        place[id] = -1;
    for (int i = 0; i < ps->n; i++)
        place[ps->id[i]] = i;
    return place;
}

static int is_there(const struct dem_spring *s, const int *place)
{
    return place[s->id] >= 0 && (s->other < 0 || place[s->other] >= 0);
}

/* A new list of the springs whose particles are there. */
static struct dem_spring *sifted(const struct dem_spring *list, int *n,
                                 const int *place)
{
    struct dem_spring *const stay = alloc_zeroed((size_t)*n, sizeof *stay);
    int count = 0;

    for (int q = 0; q < *n; q++)
        if (is_there(&list[q], place)) stay[count++] = list[q];
    *n = count;
    return stay;
}

void dem_restore_springs(struct dem *dem, const struct dem_spring *all, int n)
{
    struct neighbours *const nb = dem->neighbours;
    int *const place = places(nb->ps);
    struct dem_spring *const list = sifted(all, &n, place);
    const int own = n - surface_history_restore(nb->surfaces, list, n);
    struct contact_history *const kept = neighbours_restore_history(nb, own);

    for (int q = 0; q < own; q++) {
        kept[q].owner = place[list[q].id];
        kept[q].partner =
            list[q].other < 0 ? list[q].other : place[list[q].other];
        for (int k = 0; k < 3; k++) {
            kept[q].xi[k] = list[q].xi[k];
            kept[q].roll_angle[k] = list[q].roll_angle[k];
        }
    }
    free(list);
    free(place);
}

void dem_remove(struct dem *dem, const int *gone)
{
    int n;
    struct dem_spring *const springs = dem_springs(dem, &n);

    particles_remove(dem->neighbours->ps, gone);
    dem_restore_springs(dem, springs, n);
    free(springs);
}
