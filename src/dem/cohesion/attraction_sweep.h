/* attraction_sweep.h -- the loop over all pairs within a range.
 * Chapter "Materials, rolling and cohesion".
 *
 * As in contact_sweep.h a law is two inlined functions, so that each law has a
 * loop of its own without a call in it. Forces are along n, from j to i or
 * from the wall into the box: positive pushes apart.
 */
#ifndef DEM_COHESION_ATTRACTION_SWEEP_H
#define DEM_COHESION_ATTRACTION_SWEEP_H

#include <math.h>
#include <stddef.h>

#include "dem/cohesion/attraction.h"
#include "dem/fast/chunk.h"

#define ATTRACTION_INLINE static inline __attribute__((always_inline, unused))

/* [N] between spheres of these materials and radii. */
typedef double attraction_pair(const struct attraction *a, int of_i, int of_j,
                               double R_i, double R_j, double gap);
typedef double attraction_wall(const struct attraction *a, double R,
                               double gap);

ATTRACTION_INLINE int attraction_material(const struct bodies *b, int i)
{
    return b->material != NULL ? b->material[i] : 0;
}

ATTRACTION_INLINE void attraction_on_pairs(struct chunk *s,
                                           const struct bodies *b,
                                           const struct attraction *a, int i,
                                           attraction_pair pair)
{
    const struct neighbour_list *const v = &s->pairs;
    const int own = i - s->begin, of_i = attraction_material(b, i);
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
        const double F =
            pair(a, of_i, attraction_material(b, j), x[3], y[3], gap) / r;
        for (int k = 0; k < 3; k++) {
            s->load[own][k] += F * dx[k];
            theirs[k] -= F * dx[k];
        }
    }
}

/* The six sides of the box. */
ATTRACTION_INLINE void attraction_on_walls(struct chunk *s,
                                           const struct bodies *b,
                                           const struct attraction *a, int i,
                                           attraction_wall wall)
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
        s->load[own][k] += (upper ? -1.0 : 1.0) * wall(a, x[3], gap);
    }
}

ATTRACTION_INLINE void attraction_loop(struct chunk *s, const struct bodies *b,
                                       const struct attraction *a,
                                       attraction_pair pair,
                                       attraction_wall wall)
{
    for (int i = s->begin; i < s->end; i++) {
        attraction_on_pairs(s, b, a, i, pair);
        if (wall != NULL) attraction_on_walls(s, b, a, i, wall);
    }
}

#endif
