/* SPDX-License-Identifier: GPL-3.0-or-later */
/* tenneti.c -- random arrays of spheres, from simulations with immersed
 * boundaries [Tenneti11].
 *
 * Their factor,
 *
 *   F = F_isolated / (1 - s)^3 + 5.81 s / (1 - s)^3 + 0.48 s^(1/3) / (1 - s)^4
 *       + s^3 Re (0.95 + 0.61 s^3 / (1 - s)^2),
 *
 * is the whole force over Stokes' law at the superficial slip: at s = 0.4 and
 * Re = 0 it is 18.1, and Carman's whole force is 10 s / (1 - s)^3 = 18.5.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

static double tenneti_factor(double eps_f, double Re)
{
    const double s = 1.0 - eps_f, e3 = gsl_pow_3(eps_f), s3 = gsl_pow_3(s);

    return eps_f * (drag_sphere(Re) / e3 + 5.81 * s / e3 +
                    0.48 * cbrt(s) / (e3 * eps_f) +
                    s3 * Re * (0.95 + 0.61 * s3 / (eps_f * eps_f)));
}

static double tenneti(double eps_f, double rho_f, double mu, double d,
                      double u_r)
{
    return drag_by_factor(tenneti_factor, eps_f, rho_f, mu, d, u_r);
}

const struct drag_law drag_tenneti = {
    .name = "tenneti",
    .what = "random arrays of spheres, from resolved flow to Re = 300",
    .equations = "Tenneti11",
    .function = "tenneti",
    .eps_min = 0.5,
    .eps_max = 0.9,
    .Re_min = 0.01,
    .Re_max = 300.0,
    .resistance = tenneti,
};
