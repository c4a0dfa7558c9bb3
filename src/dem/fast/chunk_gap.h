/* chunk_gap.h -- how far a particle is from another one or a wall.
 * Chapter "Neighbours".
 */
#ifndef DEM_FAST_CHUNK_GAP_H
#define DEM_FAST_CHUNK_GAP_H

#include <math.h>

#include "dem/fast/bodies.h"

/* Gap of particles i and j, nearest image [m]. */
static inline double chunk_pair_gap(const struct bodies *b, int i, int j)
{
    const double *const x = b->position_radius[i], *const y =
                                                       b->position_radius[j];
    double r2 = 0.0;

    for (int k = 0; k < 3; k++) {
        const double dx = x[k] - y[k];
        const double L = b->box.length[k];
        const double near = dx - L * rint(dx * b->box.inverse[k]);
        r2 += near * near;
    }
    return sqrt(r2) - x[3] - y[3];
}

/* Gap of particle i and a side of the box [m]. */
static inline double chunk_wall_gap(const struct bodies *b, int i, int wall)
{
    const double *const x = b->position_radius[i];
    const int k = wall / 2;

    return (wall % 2 ? b->box.hi[k] - x[k] : x[k] - b->box.lo[k]) - x[3];
}

#endif
