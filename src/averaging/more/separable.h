/* separable.h -- diffusion in a box, direction by direction.
 * Chapter "Averaging".
 *
 * The Laplacian of a box of cells is a sum of three, one for each direction,
 * and these commute. So the exponential is a product:
 *
 *     exp(-T L) = exp(-T L_x) exp(-T L_y) exp(-T L_z)
 *
 * Each factor is a small matrix of n_k by n_k weights, the same for all lines
 * of cells in its direction. They decrease like a Gaussian, and small ones are
 * dropped. There is no linear system and no time step; each field is read and
 * written three times. The weights are not negative, those of a cell add up to
 * one, and V_i w_ij = V_j w_ji: constants and sums are conserved to rounding,
 * there are no undershoots, and the operator is self-adjoint.
 *
 * Grading, walls and periodic directions are allowed, but only a uniform
 * bandwidth, or one that depends on the widths of cells alone, and only boxes.
 */
#ifndef AVERAGING_MORE_SEPARABLE_H
#define AVERAGING_MORE_SEPARABLE_H

#include "mesh/mesh.h"

struct separable;

/* b [m]: 0, or the bandwidth of T, from which the variance of the cells is
 * subtracted (bandwidth.h, "cells"). The sum of the dropped weights of a cell
 * is less than tail [-] and is added to its own weight. NULL if the mesh is not
 * a box, or has a direction of more than SEPARABLE_MOST cells, for which
 * computing the weights would take long. */
enum { SEPARABLE_MOST = 1024 };
struct separable *separable_create(const struct box *box, double T /* [m^2] */,
                                   double b, double tail /* [-] */);

/* u becomes exp(-T L) u, for m fields side by side, u[m * i + k]. The bits do
 * not depend on the number of threads. */
void separable_apply(struct separable *s, int m, double *u);

/* The largest number of weights of a cell in direction k [-]. */
int separable_reach(const struct separable *s, int k);

#endif
