/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cello.c -- a fit to simulations of several authors over all fluid fractions
 * [Cello10], here for spheres of one size,
 *
 *   F = K_1 + K_2 eps_f^4 + K_3 (1 - eps_f^4),   K_0 = (1 - eps_f)/(1 + 3
 * eps_f).
 *
 * Its last term has a pole, at Re = 1250 in a bed and above that elsewhere.
 * From Re = 1000 on, outside of its range, the drag coefficient is therefore
 * held, and F grows with Re.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

static const double last_Re = 1000.0;

static double K_1(double eps_f, double K_0)
{
    return (1.0 + 128.0 * K_0 + 715.0 * K_0 * K_0) /
           (eps_f * eps_f * (1.0 + 49.5 * K_0));
}

static double K_2(double Re)
{
    return (1.0 + 0.130 * Re + 6.66e-4 * Re * Re) /
               (1.0 + 3.42e-2 * Re + 6.92e-6 * Re * Re) -
           1.0;
}

static double K_3(double eps_f, double Re, double K_0)
{
    const double e2 = eps_f * eps_f;
    const double above = -410.0 * eps_f + 9.20e7 * Re * gsl_pow_int(K_0, 20) +
                         1900.0 * e2 - 6.60e-2 * Re;
    const double below = 6600.0 * eps_f + 4.92e-4 * Re - 4.30e4 * e2 -
                         1.31e-4 * Re * Re + 7.38e4 * e2 * eps_f;

    return 2.0 * Re * Re / (1.0 + Re) * above / below;
}

static double cello_factor(double eps_f, double Re)
{
    const double K_0 = (1.0 - eps_f) / (1.0 + 3.0 * eps_f);
    const double e4 = gsl_pow_4(eps_f), R = fmin(Re, last_Re);
    const double F =
        K_1(eps_f, K_0) + K_2(R) * e4 + K_3(eps_f, R, K_0) * (1.0 - e4);

    return Re <= last_Re ? F : F * Re / last_Re;
}

static double cello(double eps_f, double rho_f, double mu, double d, double u_r)
{
    return drag_by_factor(cello_factor, eps_f, rho_f, mu, d, u_r);
}

const struct drag_law drag_cello = {
    .name = "cello",
    .what = "a fit to several resolved simulations, Re to 1000",
    .equations = "Cello10",
    .function = "cello",
    .eps_min = 0.36,
    .eps_max = 1.0,
    .Re_max = 1e3,
    .resistance = cello,
};
