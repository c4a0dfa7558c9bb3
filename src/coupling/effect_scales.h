/* effect_scales.h -- the scales of a case, from which each effect estimates
 * its force before the run.  Chapter "Further forces".
 *
 * A scale that the case does not have is 0.
 */
#ifndef COUPLING_EFFECT_SCALES_H
#define COUPLING_EFFECT_SCALES_H

struct effect_scales {
    double rho_f, mu;    /* [kg/m^3], [Pa s] */
    double rho_s, d;     /* [kg/m^3], [m] of the mean particle */
    double gravity;      /* [m/s^2] */
    double slip;         /* [m/s] terminal velocity, or that of the inlet */
    double shear;        /* [1/s] velocity over the width that it changes in */
    double length;       /* [m] that width */
    double spin;         /* [rad/s] of a particle against the fluid */
    double eps_s;        /* [-] solids fraction where the particles are */
    double tau;          /* [s] relaxation time */
    double acceleration; /* [m/s^2] of the slip */
    double weight;       /* [N] */
    double drag;         /* [N] at the slip */
    double force;        /* [N] the larger one of the two */
    int resting;         /* [-] 1: a bed that is not carried */
};

#endif
