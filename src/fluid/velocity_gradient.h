/* velocity_gradient.h -- the gradient of the velocity in the cells.
 * Chapter "The flow, verified".
 *
 * Gauss: (1/V) sum u_f S, u_f linear between the two cells of a face. Least
 * squares: the gradient that best gives the differences to all neighbours,
 * weighted by one over the distance squared, on tetrahedra to the fourth power;
 * exact for a linear field on any mesh. Only schemes that need more than two
 * cells use it.
 */
#ifndef FLUID_VELOCITY_GRADIENT_H
#define FLUID_VELOCITY_GRADIENT_H

#include "base/model.h"
#include "mesh/mesh.h"

/* Fills slope, 9 a cell: [9 * c + 3 * k + j] is d u_k / d x_j [1/s]. u: 3 a
 * cell; u_b: 3 a boundary face, from the first of them on [m/s], and reach [m]
 * likewise the vector from the centre of the cell to where u_b is the velocity;
 * NULL: the middle of the face. */
struct velocity_gradient_scheme {
    MODEL_MEMBERS; /* base/model.h */
    void (*fill)(const struct mesh *m, const double *reach, const double *u,
                 const double *u_b, double *slope);
};

/* The key that chooses one, for the schemes of convection that use it. */
extern const struct key velocity_gradient_keys[];

/* All schemes, ended by NULL, the default first; NULL for an unknown name. */
extern const struct velocity_gradient_scheme velocity_gradient_by_mesh,
    velocity_gradient_gauss, velocity_gradient_least_squares;
extern const struct velocity_gradient_scheme *const velocity_gradient_schemes[];
const struct velocity_gradient_scheme *
velocity_gradient_scheme_named(const char *name);

#endif
