/* bandwidth.h -- a bandwidth of the diffusion that varies in space.
 * Chapter "Further averaging methods".
 *
 *     d phi / d tau = div (D grad phi),  D = (b(x) / b)^2 [-]
 *                                           [SX15 section 2.2.3]
 *
 * b is the bandwidth that the options name, b(x) the local one:
 *
 *   regions  boxes with a bandwidth of their own; where boxes overlap the last
 *            one applies; 0 leaves the pcm field unchanged
 *   cells    b(x)^2 = b^2 - dx^2 / 3, at least 0, with the distance dx of the
 *            two centres at a face: the pcm field of a particle is already
 *            even over its cell, which has a variance of dx^2 / 6 besides the
 *            b^2 / 2 of the Gaussian. Where cells are larger than 1.7 b it
 *            leaves the pcm field [SX15 section 2.2.3]
 *   grains   b(x) = b d(x) / d_mean [SX15 section 4.1], with the mean diameters
 *            by volume of the cell and of all; d_mean where a cell has none
 *
 * D at a face is the harmonic mean of its two cells, so the sum of V phi is
 * conserved, and a constant field stays constant.
 */
#ifndef AVERAGING_MORE_BANDWIDTH_H
#define AVERAGING_MORE_BANDWIDTH_H

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"

/* 1 if there is such a rule, a value of options.vary. */
int bandwidth_has_rule(const char *vary);

/* D minus the smoothing by a cell of width dx [m], where D = 1 for the
 * bandwidth b [m]: the rule "cells". [-] */
double bandwidth_minus_cell(double D, double dx, double b);

/* 1 if D is the same on all lines of cells of a box: uniform, or by the widths
 * of its cells alone. */
int bandwidth_is_by_lines(const struct averaging_options *o);

struct bandwidth;

/* For options that name a rule or regions; the cells are borrowed. */
struct bandwidth *bandwidth_create(const struct cell_of_particle *h,
                                   const struct averaging_options *o);

/* D on each internal face [-], borrowed. */
const double *bandwidth_D(const struct bandwidth *w);

/* Computes D again where it depends on the particles. Returns 1 if D has
 * changed. */
int bandwidth_bind(struct bandwidth *w);

/* Upper bound of D in all later calls of bandwidth_bind, with the present
 * particles. */
double bandwidth_largest(const struct bandwidth *w);

#endif
