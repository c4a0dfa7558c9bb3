/* effect_scales.h -- the scales of a case, from which each effect estimates
 * its force before the run.  Chapter "Further forces".
 *
 * A scale that the case does not have is 0.
 */
#ifndef COUPLING_EFFECT_SCALES_H
#define COUPLING_EFFECT_SCALES_H

struct effect_scales {
    double rho_f, mu;     /* [kg/m^3], [Pa s] */
    double dt;            /* [s] step of the fluid */
    double rho_s, d;      /* [kg/m^3], [m] of the mean particle */
    double gravity;       /* [m/s^2] */
    double mean_gradient; /* [Pa/m] that drives the fluid through a period */
    double eps_s;         /* [-] solids fraction where the particles are */
    int carried;   /* [-] 1: the particles move with the stream, or fall */
    double slip;   /* [m/s] of a particle in the stream */
    double length; /* [m] over which the velocity changes by that */
    double shear;  /* [1/s] of the stream */
    double spin;   /* [rad/s] of a particle against the fluid */
    double tau;    /* [s] relaxation time */
    double acceleration;           /* [m/s^2] of the slip, in the mean */
    double time;                   /* [s] that the slip has had to develop */
    double weight, drag;           /* [N] */
    double force;                  /* [N] the larger one of the two */
    const struct attraction *pair; /* of the effect, if it is named */
    const double *numbers;         /* its parameters, if it is named */
};

/* Size of the force over the larger one of weight and drag. */
struct effect_estimate {
    double share;       /* [-] in the mean, or as the remark says */
    const char *remark; /* "" if there is nothing to add */
    int conditional;    /* [-] 1: only if the remark holds */
};

/* The mass that accelerates with a particle, over the mass of the fluid that it
 * displaces. */
struct added_mass {
    double C;         /* [-] for a change of the slip in this step */
    double C_history; /* [-] for one in the step before, as a force */
};

#endif
