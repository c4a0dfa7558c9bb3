/* SPDX-License-Identifier: GPL-3.0-or-later */
/* rong.c -- Di Felice's form with an exponent that depends on the fluid
 * fraction too, fitted to lattice-Boltzmann simulations of packings [Rong13]:
 * the drag of one sphere at the superficial slip times eps_f^-chi. The drag
 * coefficient is DallaValle's. */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

/* chi = 2.65 (eps_f + 1) - (5.3 - 3.5 eps_f) eps_f^2 exp(-(1.5 - log10 Re)^2 /
 * 2) [Rong13]. */
static double rong_exponent(double eps_f, double Re)
{
    const double a = 1.5 - log10(Re);
    const double bell = Re > 0.0 ? exp(-0.5 * a * a) : 0.0;

    return 2.65 * (eps_f + 1.0) - (5.3 - 3.5 * eps_f) * eps_f * eps_f * bell;
}

static double rong_factor(double eps_f, double Re)
{
    const double root = 0.63 * sqrt(Re) + 4.8; /* C_d Re = root^2 */

    return root * root / 24.0 * pow(eps_f, -rong_exponent(eps_f, Re));
}

static double rong(double eps_f, double rho_f, double mu, double d, double u_r)
{
    return drag_by_factor(rong_factor, eps_f, rho_f, mu, d, u_r);
}

const struct drag_law drag_rong = {
    .name = "rong",
    .what = "packings of spheres, from resolved flow; the form of Di Felice",
    .equations = "Rong13",
    .function = "rong",
    .eps_min = 0.37,
    .eps_max = 1.0,
    .Re_max = 3e3,
    .resistance = rong,
};
