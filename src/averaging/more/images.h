/* images.h -- a Gaussian around each particle, with mirror images behind the
 * walls.
 * Chapter "Further averaging methods".
 *
 *     W(r) = exp(-r^2 / 2 sigma^2) / (sigma sqrt(2 pi))^3            [EW18 19]
 *     sigma = delta_05 / (2 sqrt(2 ln 2)),  b = sqrt(2) sigma        [EW18 20]
 *     W_nw(x - x_i) = W(x - x_i) + W(x - x_image)                    [EW18 21]
 *     w_ic = integral of W_nw over cell c / that over all cells  [EW18 17, 18]
 *
 * delta_05 [m] is where W has half its height, as a width from side to side. b
 * is that of the diffusion [SX15 6]: this is the kernel that diffusion amounts
 * to, without a differential equation. The integrals are exact for cells of any
 * size; W is cut off at 3 b from the cell of the particle.
 *
 * EW18 normalise the sum (18) at each point of the mesh, which does not
 * conserve volume; here the weights of each particle sum to one.
 *
 * Only for boxes, whose walls are planes; there are images of images.
 */
#ifndef AVERAGING_MORE_IMAGES_H
#define AVERAGING_MORE_IMAGES_H

#include "averaging/averaging_method.h"

extern const struct averaging_method images_method;

/* [EW18 19] at the distance r [m]: W [1/m^3]. */
double images_kernel(double r, double sigma);

#endif
