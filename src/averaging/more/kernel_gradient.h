/* kernel_gradient.h -- the gradient of a field at a particle, by a kernel.
 *
 * Chapter "Further averaging methods".
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
 * and of first order only, and so is X: EW18 state this, and the test shows it.
 */
#ifndef AVERAGING_MORE_KERNEL_GRADIENT_H
#define AVERAGING_MORE_KERNEL_GRADIENT_H

#include "averaging/cell_of_particle.h"

struct kernel_gradient;

/* The cells are borrowed. b [m]; the kernel is followed to 3 b. */
struct kernel_gradient *kernel_gradient_create(const struct cell_of_particle *h,
                                               double b);
void kernel_gradient_free(struct kernel_gradient *s);

/* X of m fields side by side, at the particles of the last
 * cell_of_particle_find: X[3 * (m * i + k) + j] is d field_k / d x_j at
 * particle i. */
void kernel_gradient_find(const struct kernel_gradient *s, int m,
                          const double *field, double *X);

/* The slope at x [m] from the middle of the second of three cells of width h
 * [m] in a row, by a kernel of bandwidth b [m] [EW18 B.7]. */
double kernel_gradient_row(double h, double b, double x, double phi_1,
                           double phi_2, double phi_3);

#endif
