/* skewness.h -- faces whose middle the link of their cells misses.
 * Chapter "The flow, verified".
 *
 * The value linear between two cells is that where their link crosses the face.
 * On tetrahedra the middle of the face is off that point, by a vector off, and
 * what a sum over faces needs is the value there:
 *
 *   x_f = w x_P + (1 - w) x_N + off . grad x
 *
 * Without the second term the gradient of a linear field is wrong on the finest
 * mesh, too. The terms are taken from the gradients known so far; that of the
 * pressure, on meshes with tetrahedra, from least squares, which are exact for
 * a linear pressure.
 */
#ifndef FLUID_DEFERRED_SKEWNESS_H
#define FLUID_DEFERRED_SKEWNESS_H

#include "fluid/deferred.h"
#include "fluid/fluid.h"

/* off of each face [m], 3 each, of a boundary face the part of the link along
 * the face; NULL, which the functions below are not called with, for a mesh
 * without. It is at most 0.8 of the link, and 0 where that is at more than 63
 * degrees to the normal: in flat cells the terms would otherwise amplify
 * themselves. */
double *skewness_of(const struct mesh *m);

/* The sums of d d / |d|^4 over the links of each cell [1/m^2], 6 each
 * (vector.h), of a boundary face with the part of the link normal to it; NULL
 * for a mesh without tetrahedra. */
double *skewness_normal_equations(const struct mesh *m, const double *off);

/* Adds the term to p_face, from the gradients of the linear values. */
void skewness_add_pressures(const struct deferred *d, struct fluid *fl);

/* Adds it to the fluxes without the pressure; to the convection of the momentum
 * equation, as far as the scheme is of second order. */
void skewness_add_fluxes(const struct deferred *d, struct fluid *fl);
void skewness_add_convection(const struct deferred *d, struct fluid *fl,
                             const double *u);

#endif
