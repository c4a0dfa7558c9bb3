/* bandwidth.h -- a bandwidth of the diffusion that varies in space. Chapter 21.
 *
 *     d phi / d tau = div (D grad phi),  D = (b(x) / b)^2 [-]
 *                                           [SX15 section 2.2.3]
 *
 * b is the bandwidth that the options name, b(x) the local one:
 *
 *   regions  boxes that have a bandwidth of their own, the last one named
 *            counts; 0 leaves the pcm field there
 *   cells    b(x)^2 = b^2 - dx^2 / 3, at least 0, with the distance dx of the
 *            two centres at a face: what has gone to the host and is shown as
 *            even in it is smeared over a cell already, which counts dx^2 / 6
 *            of variance beside the b^2 / 2 of the Gaussian. Where cells are
 *            larger than 1.7 b it leaves the pcm field [SX15 section 2.2.3]
 *   grains   b(x) = b d(x) / d_mean, with the mean diameters by volume of the
 *            cell and of all; d_mean where a cell has no particles [SX15
 * section 4.1]
 *
 * D is symmetric in the two cells of a face, their harmonic mean: so the sum
 * of V phi stays what it is, and a constant stays constant.
 */
#ifndef BANDWIDTH_H
#define BANDWIDTH_H

#include "averaging/averaging.h"
#include "averaging/hosts.h"

/* The names for options.vary, ended by NULL; the first is the default: not. */
extern const char *const bandwidth_rules[];

/* D less what a cell that is dx [m] wide smears by itself, where b [m] has D =
 * 1: the rule "cells". [-] */
double bandwidth_less_cell(double D, double dx, double b);

/* 1 if D is the same on all lines of cells of a box: uniform, or by the widths
 * of its cells alone. */
int bandwidth_is_by_lines(const struct averaging_options *o);

struct bandwidth;

/* NULL if the options name no variation; the hosts are borrowed. */
struct bandwidth *bandwidth_create(const struct hosts *h,
                                   const struct averaging_options *o);
void bandwidth_free(struct bandwidth *w);

/* D on each internal face [-], borrowed. */
const double *bandwidth_D(const struct bandwidth *w);

/* Where D follows the grains: finds it anew. Returns 1 if D is another. */
int bandwidth_bind(struct bandwidth *w);

/* The largest D that any later bind can give, with the particles of now. */
double bandwidth_largest(const struct bandwidth *w);

#endif
