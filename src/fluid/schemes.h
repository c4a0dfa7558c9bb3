/* schemes.h -- the schemes of the time derivative and of convection. */
#ifndef FLUID_SCHEMES_H
#define FLUID_SCHEMES_H

#include "base/model.h"
#include "mesh/mesh.h"

/* --- time scheme ---------------------------------------------------------- */

/* Schemes for the time derivative of momentum.
 *
 *   dt d(eps u)/dt = now (eps u)^(n+1) - old (eps u)^n + older (eps u)^(n-1)
 *
 * The weights satisfy now - old + older = 0, so that a constant has no
 * derivative. A scheme also gives the factor of extrapolation for quantities
 * that lag by a step, such as the convecting flux: x + ahead (x - x_older). */

struct time_weights {
    double now, old, older; /* [-] */
    double ahead;           /* [-] */
};

struct time_scheme {
    MODEL_MEMBERS;   /* base/model.h */
    int time_levels; /* [-] number of old time levels: 1 or 2 */
    /* [-] of a gain of 1 in a step, what the steps after it add, all as long,
     * without a force: the sum of (older / now)^n. */
    double pending;
    /* r: this step over the one before it; 0 where there is none. */
    struct time_weights (*weights)(double r /* [-] */);
};

/* All schemes, ended by NULL, the default first; NULL for an unknown name. */
extern const struct time_scheme time_scheme_euler, time_scheme_bdf2;
extern const struct time_scheme *const time_schemes[];
const struct time_scheme *time_scheme_named(const char *name);

/* --- convection ----------------------------------------------------------- */

/* The face velocity of convected momentum. Chapter "Averaged flow".
 *
 * u_f = weight u_owner + (1 - weight) u_neighbour + beyond
 *
 * A scheme computes the weight of the owner from the flux and the linear
 * weight of the face; this weight is used in the matrix. A scheme that uses
 * more than the two cells has a second, explicit part, which is computed from
 * the velocities known so far and added to the right-hand side (deferred
 * correction). */

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
    /* What it leaves of a wave of wave number k in one radian: error (k
     * h)^order; over that of second-upwind a share of upwind's and at least
     * `least`, in a cavity and in a layer (study convection). And what the
     * equations of the flow take, over upwind [-]. */
    double order, error, share, least[2], time;
    int damps; /* 1: dissipative, its truncation error damps oscillations from
                  cell to cell */
};

/* All schemes, ended by NULL, the default first; NULL for an unknown name. */
extern const struct convection_scheme convection_upwind, convection_linear,
    convection_blended, convection_second_upwind, convection_van_leer;
extern const struct convection_scheme *const convection_schemes[];
const struct convection_scheme *convection_scheme_named(const char *name);

/* The gradient of the velocity in the cells.
 *
 * Gauss: (1/V) sum u_f S, u_f linear between the two cells of a face. Least
 * squares: the gradient that best gives the differences to all neighbours,
 * weighted by one over the distance squared, on tetrahedra to the fourth power;
 * exact for a linear field on any mesh. Only schemes that need more than two
 * cells use it. */

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
