/* deferred_terms.h -- the explicit terms of the fluid that use gradients.
 * Chapter "The flow, verified".
 */
#ifndef FLUID_DEFERRED_DEFERRED_TERMS_H
#define FLUID_DEFERRED_DEFERRED_TERMS_H

#include "fluid/deferred.h"
#include "fluid/fluid.h"

struct deferred_terms {
    struct deferred hooks;    /* the first member */
    double *slope;            /* [1/s] gradient of the velocity, 9 a cell */
    double *u_boundary;       /* [m/s] the velocity on the boundary, 3 a face */
    double *off;              /* [m] of skewness.h; NULL for a mesh without */
    double *normal_equations; /* [1/m^2] of least squares, likewise; NULL
                                 without tetrahedra */
};

/* non_orthogonal.c: adds to the fluxes what the pressure gradient drives
 * through the part of the area vector that is not along the link. */
void deferred_terms_add_oblique_fluxes(struct fluid *fl);

#endif
