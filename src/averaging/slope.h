/* slope.h -- the gradient of a field at a particle, by a kernel.  Chapter 21.
 *
 *     phi_i = int phi W dx / int W dx                         [EW18 B.1-B.3]
 *     sum_n X_n int (x_n - x_i,n) dW/dx_m dx =
 *         int (phi - phi_i) dW/dx_m dx,   X = grad phi        [EW18 B.4-B.10]
 *
 * with W the Gaussian of bandwidth b around the particle, and sums over cells
 * for integrals. dW/dx = -(x - x_i) W / sigma^2, and the factor cancels. In a
 * direction in which there is one cell only, the slope is 0.
 *
 * Of second order inside. Next to a wall phi_i is the mean over half a kernel
 * and of first order only, and so is X: EW18 say so, the test shows it.
 */
#ifndef SLOPE_H
#define SLOPE_H

#include "averaging/hosts.h"

struct slope;

/* The hosts are borrowed. b [m]; the kernel is followed to 3 b. */
struct slope *slope_create(const struct hosts *h, double b);
void slope_free(struct slope *s);

/* X of m fields side by side, at the particles of the last hosts_find:
 * X[3 * (m * i + k) + j] is d field_k / d x_j at particle i. */
void slope_find(const struct slope *s, int m, const double *field, double *X);

/* Solves A x = b for a symmetric A that may have rows of zeros, where x is 0:
 * so far below its largest entry counts as zero. */
void slope_solve(const double A[6], const double b[3], double x[3]);

#endif
