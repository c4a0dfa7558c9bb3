/* images_poly.h -- a Gaussian with mirror images on cells of any shape.
 *
 * Chapter "Further averaging methods".
 *
 *     w_ic = sum over c and its images of
 *         V_c N(x_i - x_c; b^2 / 2 + M_c) over the sum of that      (21.6)
 *
 * N is the normal density of that covariance and M_c that of the cell itself,
 * the mean of r r^T over it (gaussian_moments.h). The images themselves are
 * described in wall_images.h.
 *
 * Near flat walls the field of a uniform bed is then uniform. Near other walls
 * the heights of the cells are scaled until it is: each cell has one height,
 * and the weights of each particle still add up to one.
 */
#ifndef AVERAGING_POLY_IMAGES_POLY_H
#define AVERAGING_POLY_IMAGES_POLY_H

#include "averaging/averaging_method.h"

/* The variant of the method "images" for a mesh that is no box. */
extern const struct averaging_method images_poly_method;

#endif
