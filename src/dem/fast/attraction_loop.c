/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/attraction_loop.h"

#include <math.h>
#include <stddef.h>

static int attraction_loop_material_of(const struct bodies *b, int i)
{
    return b->material != NULL ? b->material[i] : 0;
}

/* The damping force [N] of i and j; x [m] points from j to i and has the length
 * r [m]. */
static double damped(const struct bodies *b, const struct attraction *a, int i,
                     int j, const double x[3], double r, double gap)
{
    const double *const v = b->velocity[i], *const u = b->velocity[j];
    const double R = b->position_radius[i][3], S = b->position_radius[j][3];
    double closing = 0.0;

    for (int k = 0; k < 3; k++)
        closing -= (v[k] - u[k]) * x[k] / r;
    return attraction_damp(a, R * S / (R + S), gap, closing, v[7] + u[7],
                           b->step);
}

static void add_pairs(struct chunk *s, const struct bodies *b,
                      const struct attraction *a, int i)
{
    const struct neighbour_list *const v = &s->pairs;
    const int own = i - s->begin, of_i = attraction_loop_material_of(b, i);
    const double *const x = b->position_radius[i];

    for (int q = v->start[own]; q < v->start[own + 1]; q++) {
        const int j = v->partner[q], at = j - s->begin;
        const double *const y = b->position_radius[j];
        double *const theirs = s->load[at < 0 ? at + b->n : at];
        double dx[3], r2 = 0.0;

        for (int k = 0; k < 3; k++) {
            dx[k] = x[k] - y[k];
            dx[k] -= b->box.length[k] * rint(dx[k] * b->box.inverse[k]);
            r2 += dx[k] * dx[k];
        }
        const double r = sqrt(r2), gap = r - x[3] - y[3];
        if (gap > a->range) continue;
        double F = 0.0;
        if (a->law->pair != NULL)
            F = a->law->pair(a, of_i, attraction_loop_material_of(b, j), x[3],
                             y[3], gap);
        if (a->law->damping != NULL) F += damped(b, a, i, j, dx, r, gap);
        for (int k = 0; k < 3; k++) {
            s->load[own][k] += F / r * dx[k];
            theirs[k] -= F / r * dx[k];
        }
    }
}

/* Adds the forces of the six sides of the box. */
static void attraction_loop_add_walls(struct chunk *s, const struct bodies *b,
                                      const struct attraction *a, int i)
{
    const struct neighbour_list *const v = &s->walls;
    const int own = i - s->begin;
    const double *const x = b->position_radius[i];

    for (int q = v->start[own]; q < v->start[own + 1]; q++) {
        const int k = v->partner[q] / 2, upper = v->partner[q] % 2;
        if (k > 2) continue;
        const double gap =
            (upper ? b->box.hi[k] - x[k] : x[k] - b->box.lo[k]) - x[3];
        if (gap > a->range) continue;
        const double out = upper ? -1.0 : 1.0;
        if (a->law->wall != NULL)
            s->load[own][k] += out * a->law->wall(a, x[3], gap);
        if (a->law->damping != NULL)
            s->load[own][k] +=
                out * attraction_damp(a, x[3], gap, -out * b->velocity[i][k],
                                      b->velocity[i][7], b->step);
    }
}

void attraction_loop_add(struct chunk *s, const struct bodies *b,
                         const struct attraction *a)
{
    for (int i = s->begin; i < s->end; i++) {
        add_pairs(s, b, a, i);
        if (a->law->wall != NULL || a->law->damping != NULL)
            attraction_loop_add_walls(s, b, a, i);
    }
}
