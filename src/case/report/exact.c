/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/exact.h"

#include "coupling/drag.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <math.h>

struct stream {
    const struct drag_law *law;
    double rho_s, eps_s, rho_f, mu, d, u_f;
};

/* [XS11 4.1] */
static int acceleration(double t, const double u[], double dudt[], void *of)
{
    const struct stream *const s = of;
    const double u_r = s->u_f - u[0];

    (void)t;
    dudt[0] = u_r / drag_relaxation_time(s->law, s->rho_s, s->eps_s, s->rho_f,
                                         s->mu, s->d, fabs(u_r));
    return isfinite(dudt[0]) ? GSL_SUCCESS : GSL_EBADFUNC;
}

/* Runge-Kutta of order 8, to 1e-11 of the velocity. */
double exact_released(double rho_s, double eps_s, double rho_f, double mu,
                      double d, double u_f, double t)
{
    struct stream s = {
        drag_law_named("syamlal-obrien"), rho_s, eps_s, rho_f, mu, d, u_f};
    gsl_odeiv2_system system = {acceleration, NULL, 1, &s};
    double u[1] = {0.0}, now = 0.0;

    if (!(t >= 0.0)) return NAN;
    if (t == 0.0) return 0.0;
    gsl_odeiv2_driver *const driver = gsl_odeiv2_driver_alloc_y_new(
        &system, gsl_odeiv2_step_rk8pd, 1e-4 * t, 1e-11 * fabs(u_f), 0.0);
    const int status = gsl_odeiv2_driver_apply(driver, &now, t, u);
    gsl_odeiv2_driver_free(driver);
    return status == GSL_SUCCESS ? u[0] : NAN;
}
