/* dpvm.h -- a particle divided among the cells that it overlaps.
 * Chapter "Further averaging methods".
 *
 *     w_ic = |body_i and cell c| / sum_m |body_i and cell m|
 *
 * dpvm  the body is the sphere itself: the divided particle volume method
 *       [SX15 section 1, LS section 5.4]. The solid fraction of a cell never
 *       exceeds 1 unless particles overlap.
 * cube  the body is the cube around the sphere [EW18 section 2.4]: cheaper,
 *       and a little smoother.
 *
 * Exact for cells of any shape, also where they are smaller than the particle:
 * overlap.h for boxes, graded or periodic, facets.h for all others. The weights
 * are normalised, so the part of a body beyond a wall is distributed in the
 * same proportions.
 */
#ifndef AVERAGING_MORE_DPVM_H
#define AVERAGING_MORE_DPVM_H

#include "averaging/averaging_method.h"

extern const struct averaging_method dpvm_method;
extern const struct averaging_method dpvm_cube_method;

#endif
