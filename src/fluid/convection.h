/* convection.h -- the face velocity of convected momentum.
 * Chapter "Averaged flow".
 *
 * u_f = weight u_owner + (1 - weight) u_neighbour + beyond
 *
 * A scheme computes the weight of the owner from the flux and the linear weight
 * of the face; this weight is used in the matrix. A scheme that uses more than
 * the two cells has a second, explicit part, which is computed from the
 * velocities known so far and added to the right-hand side (deferred
 * correction).
 * Chapter "The flow, verified".
 */
#ifndef FLUID_CONVECTION_H
#define FLUID_CONVECTION_H

#include "base/model.h"

/* The input of a scheme for faces 0 .. n - 1. */
struct convection_faces {
    int n;
    const double *phi; /* [m^3/s] */
    const double *w;   /* [-] weight of the owner in linear interpolation */
    double blend;      /* [-] fraction of linear, for the scheme `blended` */
};

struct convection_scheme {
    MODEL_MEMBERS; /* base/model.h */
    void (*owner_weights)(const struct convection_faces *faces,
                          double *weight /* [-] */);
    /* The velocity of a face minus that of the cell C upstream [m/s]. step: u_D
     * - u_C, with D the cell downstream; rise: grad u_C . d, with d the link
     * from C to D [m/s]; reach: the part of the link that is within C [-].
     * NULL: the scheme has no such part. */
    double (*deferred)(double step, double rise, double reach);
    int damps; /* 1: dissipative, its truncation error damps oscillations from
                  cell to cell */
};

/* All schemes, ended by NULL, the default first; NULL for an unknown name. */
extern const struct convection_scheme convection_upwind, convection_linear,
    convection_blended, convection_second_upwind, convection_van_leer;
extern const struct convection_scheme *const convection_schemes[];
const struct convection_scheme *convection_scheme_named(const char *name);

/* The weights of upwind, which schemes with a deferred part use as well. */
void convection_upwind_weights(const struct convection_faces *faces,
                               double *weight);

#endif
