/* two_grid.h -- particles averaged on a coarser grid of their own.
 * Chapter "Further averaging methods".
 *
 *     eps_C = sum of the V_p with their centre in C / sum_c |c and C|
 *     eps_c = sum_C |c and C| eps_C / V_c                     [LS section 5.4]
 *
 * The grid is a box of equal cells C around the mesh, as many as have at least
 * the bandwidth for their width in each direction (or one). Its size is chosen
 * for the particles, that of the mesh for the flow. |c and C| is exact for
 * cells of any shape. Volume is conserved on any mesh, because the volume of C
 * is the sum of its overlaps with the cells of the mesh.
 */
#ifndef AVERAGING_MORE_TWO_GRID_H
#define AVERAGING_MORE_TWO_GRID_H

#include "averaging/averaging_method.h"

extern const struct averaging_method two_grid_method;

#endif
