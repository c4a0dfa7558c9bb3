/* dpvm.h -- a particle divided among the cells that it overlaps.  Chapter 8.
 *
 *     w_ic = |body_i and cell c| / sum_m |body_i and cell m|
 *
 * dpvm  the body is the sphere itself: the divided particle volume method
 *       [SX15 section 1, LS section 5.4]. No cell gets more than it has room
 *       for.
 * cube  the body is the cube around the sphere [EW18 section 2.4]: cheaper,
 *       and a little smoother.
 *
 * Exact for cells of any shape, also where they are smaller than the particle:
 * overlap.h for boxes, graded or periodic, facets.h for all others. What of a
 * body lies beyond a wall is shared out like the rest.
 */
#ifndef DPVM_H
#define DPVM_H

#include "averaging/averaging_method.h"

extern const struct averaging_method dpvm_method;
extern const struct averaging_method dpvm_cube_method;

#endif
