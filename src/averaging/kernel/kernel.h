/* kernel.h -- a particle spread over the cells around it.
 * Chapter "Averaging".
 *
 *     w_ic = K(|x_i - x_c| / b) V_c / sum_m K(|x_i - x_m| / b) V_m       (8.7)
 *     field_c = (1 / V_c) sum_i w_ic q_i             [XS11 3.2, 3.5a, 3.7, 3.8]
 *     q_i = sum_c w_ic field_c                                     [XS11 3.9]
 *
 * The weights of a particle sum to one over the cells, so nothing is lost at a
 * wall or anywhere else, whatever K is [XS11 3.4]. A particle with no cell
 * centre within b is assigned to its own cell. [XS11] advises b of 1.5 to 2.5
 * mean cell sizes.
 *
 * As printed, the weights have no V_c: the cells of [XS11] are equal, and it
 * cancels. K V_c is the integral of K over the cell by the midpoint rule, and
 * without V_c small cells beside large ones would seem fuller (8.7).
 *
 *     bell      K = (1 - zeta^2)^4 for |zeta| < 1, else 0           [XS11 3.6]
 *     gaussian  K = exp(-zeta^2) for |zeta| < 3, else 0       [SX15 6 and 4.1]
 */
#ifndef AVERAGING_KERNEL_KERNEL_H
#define AVERAGING_KERNEL_KERNEL_H

#include "averaging/averaging_method.h"

extern const struct averaging_method kernel_method;
extern const struct averaging_method kernel_gaussian_method;

/* [XS11 3.6], the bell: K = (1 - zeta^2)^4 for |zeta| < 1, else 0. [-] */
double kernel_bell(double zeta);

#endif
