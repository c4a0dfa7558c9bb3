/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/surface_springs.h"

#include <string.h>

/* `other` of them all: after the walls of the box, -1 to -6. */
enum { SURFACE_SPRING = -7 };

int surface_springs(struct surfaces *sf, const struct particles *ps,
                    struct dem_spring *list)
{
    int n = 0;

    for (int s = 0; sf != NULL && s < sf->count; s++) {
        const struct footprints *const f = surfaces_springs(sf, s, ps);
        for (int q = 0; q < f->n; q++, n++) {
            if (list == NULL) continue;
            list[n].id = f->list[q].id;
            list[n].other = SURFACE_SPRING;
            memcpy(list[n].xi, f->list[q].xi, sizeof list[n].xi);
            memcpy(list[n].roll, f->list[q].roll, sizeof list[n].roll);
            memcpy(list[n].n, f->list[q].n, sizeof list[n].n);
        }
    }
    return n;
}

int surface_springs_recall(struct surfaces *sf, const struct dem_spring *list,
                           int n)
{
    int many = 0;

    if (sf != NULL) surfaces_forget(sf);
    while (many < n && list[n - many - 1].other == SURFACE_SPRING)
        many++;
    for (int q = n - many; q < n && sf != NULL; q++) {
        struct footprint one = {.id = list[q].id};
        memcpy(one.n, list[q].n, sizeof one.n);
        memcpy(one.xi, list[q].xi, sizeof one.xi);
        memcpy(one.roll, list[q].roll, sizeof one.roll);
        surfaces_recall(sf, &one);
    }
    return many;
}
