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
    const double *eps_new,
        *eps_old; /* [-] fluid fraction of the mass with velocity u at the end
                     and at the beginning of the step */
    const double *eps_older; /* [-] the same one step earlier, with ddt_older;
                                else NULL */
    double *ddt;             /* [kg/s] old rho eps_old V / dt */
    double *ddt_older;       /* [kg/s] the part of a two-step scheme, or NULL */
    double *old_time_source; /* [N] the two times the velocities before the
                                step */
    double *phi_old;         /* [m^3/s] the flux before the step */
    const double *convecting_flux; /* [m^3/s] the flux that convects momentum:
                                      phi_old, or */
    double *convecting_flux_own;   /* [m^3/s] a separate one, if the scheme
                                      needs it */
    double *u_known; /* [m/s] u extrapolated to the new time; or NULL: u */
};

/* ddt.c: sets the terms of the previous steps; sets the convecting flux of
 * an outer iteration; stores the terms for the next step. */
void ddt_begin(struct fluid *fl);
void ddt_renew_flux(struct fluid *fl);
void ddt_end(struct fluid *fl);

/* 1 if the step has outer iterations or a two-step scheme: convected mass and
 * flux are then those of the new time, not of the previous step. */
int ddt_uses_new_time(const struct fluid_options *o);

#endif
