/* time_levels.h -- what the time derivative takes from the previous steps.
 * Chapter "The flow, verified".
 *
 *   (now eps_new u - old eps_old u_n + older eps_older u_nm1) rho V / dt
 *
 * The fluid fractions are those of the mass that has the velocity u: eps,
 * eps_n, eps_nm1 of struct fluid, or each one step earlier (ddt.c).
 */
#ifndef FLUID_TIME_LEVELS_H
#define FLUID_TIME_LEVELS_H

#include "fluid/fluid.h"

struct time_levels {
    struct time_weights weights; /* [-] now, old, older of this step */
    /* The fluid fraction of the mass with the velocity u at the end of the step
     * and at its beginning, and one step earlier in a two-step scheme [-]. */
    const double *eps_new, *eps_old, *eps_older;
    double *ddt;             /* [kg/s] old rho eps_old V / dt */
    double *ddt_older;       /* [kg/s] -older rho eps_older V / dt, or NULL */
    double *old_time_source; /* [N] ddt u_n + ddt_older u_nm1 */
    double *phi_old;         /* [m^3/s] the flux before the step */
    /* The flux that convects momentum is phi_old or, if the scheme needs one of
     * its own, convecting_flux_own [m^3/s]. */
    const double *convecting_flux;
    double *convecting_flux_own;
    double *u_known;      /* [m/s] u extrapolated to the new time; NULL: u */
    double reweighted[3]; /* [N s] change of what is pending of the last gain,
                             because the step has changed */
};

/* ddt.c: sets the terms of the previous steps; sets the convecting flux of
 * an outer iteration; stores the terms for the next step. */
void ddt_begin(struct fluid *fl);
void ddt_renew_flux(struct fluid *fl);
void ddt_end(struct fluid *fl);

/* What follows of a gain of momentum, of 1 [-]: see time_scheme.h. */
double ddt_pending(const struct fluid *fl);

/* 1 if the step has outer iterations or a two-step scheme: convected mass and
 * flux are then those of the new time, not of the previous step. */
int ddt_uses_new_time(const struct fluid_options *o);

#endif
