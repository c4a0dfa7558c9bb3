/* boundary_reach.h -- where the velocity of a boundary face holds, and the
 * velocity gradient of a flow with it.  Chapter "The flow, verified".
 */
#ifndef FLUID_DEFERRED_BOUNDARY_REACH_H
#define FLUID_DEFERRED_BOUNDARY_REACH_H

#include "fluid/fluid.h"

/* From the centre of the cell to where the velocity of its boundary face holds
 * [m], 3 a boundary face: the middle of the face, or the foot of the centre at
 * slip walls and outlets, which have the velocity of the cell, and at walls
 * that rotate. NULL: the middle everywhere. */
double *boundary_reach(const struct mesh *m, const struct boundary *b);

/* The gradient of u, a velocity of all cells, with u_b on the boundary faces
 * (velocity_gradient.h) [1/s]. */
void boundary_reach_gradient(const struct fluid *fl, const double *u,
                             const double *u_b, double *slope);

#endif
