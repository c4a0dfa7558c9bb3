/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/crossings.h"

static int is_fast(const struct neighbours *nb, int i, double dt)
{
    const double *const v = nb->bodies->velocity[i];
    const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];

    return 4.0 * v2 * dt * dt > nb->smallest * nb->smallest;
}

static int crossings_cross(const struct bodies *b, int i, int j, double dt)
{
    const double *const a = b->position_radius[i], *const c =
                                                       b->position_radius[j];
    double x[3], way[3];

    for (int k = 0; k < 3; k++) {
        x[k] = box_domain_nearest(&b->box, k, a[k] - c[k]);
        way[k] = (b->velocity[i][k] - b->velocity[j][k]) * dt;
    }
    return crossing(x, way, a[3] + c[3]);
}

struct dem_crossing crossings_find(const struct neighbours *nb, double dt)
{
    const struct bodies *const b = nb->bodies;

    for (int i = 0; i < b->n; i++)
        for (int j = 0; j < b->n && is_fast(nb, i, dt); j++)
            if (j != i && crossings_cross(b, i, j, dt))
                return (struct dem_crossing){1, {b->id[i], b->id[j]}};
    return (struct dem_crossing){0};
}
