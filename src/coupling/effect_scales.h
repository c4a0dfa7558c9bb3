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
    double rho_s, d;      /* [kg/m^3], [m] of the mean particle, a grain */
    double across;        /* [-] diameter of a parcel of them over theirs */
    double gravity;       /* [m/s^2] */
    double mean_gradient; /* [Pa/m] that drives the fluid through a period */
    double eps_s;         /* [-] solids fraction where the particles are */
    int partners;         /* [-] 1: there are others that a particle can meet */
    int carried;     /* [-] 1: the particles move with the stream, or fall */
    int rests;       /* [-] 1: they lie on each other, at the end at least */
    int stirred;     /* [-] 1: the spin is what collisions leave */
    double slip;     /* [m/s] of a particle in the stream */
    double length;   /* [m] over which the velocity changes by that */
    double shear;    /* [1/s] of the stream */
    double spin;     /* [rad/s] of a particle against the fluid */
    double tau;      /* [s] relaxation time */
    double meetings; /* [1/s] of a particle with others */
    double acceleration;           /* [m/s^2] of the slip, in the mean */
    double time;                   /* [s] that the slip has had to develop */
    double weight, drag;           /* [N] */
    double force;                  /* [N] the larger one of the two */
    const struct attraction *pair; /* of the effect, if it is named */
    const double *numbers;         /* its parameters, if it is named */
};

/* What an effect would do, as a share of `of`; and whether that is known before
 * a run, from the range of the data behind it. */
struct effect_estimate {
    double share;     /* [-] its size, in the mean or at most */
    double loss;      /* [-] of this the part that is missed without it: less
                         where its direction is random */
    const char *of;   /* "the force on a grain" */
    int unknown;      /* [-] 1: only what the remark says would tell */
    char remark[112]; /* "" if there is nothing to add */
};

/* The mass that accelerates with a particle, over the mass of the fluid that it
 * displaces. */
struct added_mass {
    double C;         /* [-] for a change of the slip in this step */
    double C_history; /* [-] for one in the step before, as a force */
};

#endif
