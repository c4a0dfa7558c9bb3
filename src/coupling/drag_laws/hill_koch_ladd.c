/* SPDX-License-Identifier: GPL-3.0-or-later */
/* hill_koch_ladd.c -- random arrays of spheres from lattice-Boltzmann
 * simulations [Hill01], in the form that covers all solid fractions and
 * Reynolds numbers [Benyahia06].
 *
 * F is the whole force over Stokes' law at the superficial slip, and their Re
 * is that of the radius, half of ours.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

/* Carman's packed bed where s >= 0.4; below, mixed with the ratio r of
 * polynomials by w, which is 1 at s = 0.4. */
static double slow_flow(double s, double r)
{
    const double carman = 10.0 * s / gsl_pow_3(1.0 - s);
    const double w = exp(-10.0 * (0.4 - s) / s);

    return s < 0.4 ? (1.0 - w) * r + w * carman : carman;
}

static double numerator(double s, double last)
{
    return 1.0 + 3.0 * sqrt(s / 2.0) + 135.0 / 64.0 * s * log(s) + last * s;
}

static double F_0(double s)
{
    return slow_flow(s, numerator(s, 17.14) /
                            (1.0 + s * (0.681 + s * (-8.48 + s * 8.16))));
}

static double F_1(double s)
{
    return s <= 0.1 ? sqrt(2.0 / s) / 40.0 : 0.11 + 0.00051 * exp(11.6 * s);
}

static double F_2(double s)
{
    return slow_flow(s, numerator(s, 17.89) /
                            (1.0 + s * (0.681 + s * (-11.03 + s * 15.41))));
}

static double F_3(double s)
{
    return s < 0.0953 ? 0.9351 * s + 0.03667
                      : 0.0673 + 0.212 * s + 0.0232 / gsl_pow_5(1.0 - s);
}

/* F_2 + F_3 Re, and below the Re where they meet Oseen's 1 + (3/8) Re (a lone
 * sphere) or F_0 + F_1 Re^2 (an array). */
static double whole_force(double s, double Re)
{
    const double F2 = s > 0.0 ? F_2(s) : 1.0, fast = F2 + F_3(s) * Re;

    if (s <= 0.01)
        return Re <= (F2 - 1.0) / (3.0 / 8.0 - F_3(s)) ? 1.0 + 3.0 / 8.0 * Re
                                                       : fast;
    const double F0 = F_0(s), F1 = F_1(s), F3 = F_3(s);
    const double root = F3 * F3 - 4.0 * F1 * (F0 - F2);
    return root > 0.0 && Re <= (F3 + sqrt(root)) / (2.0 * F1)
               ? F0 + F1 * Re * Re
               : fast;
}

static double hill_koch_ladd_factor(double eps_f, double Re)
{
    return eps_f * whole_force(1.0 - eps_f, Re / 2.0);
}

static double hill_koch_ladd(double eps_f, double rho_f, double mu, double d,
                             double u_r)
{
    return drag_by_factor(hill_koch_ladd_factor, eps_f, rho_f, mu, d, u_r);
}

const struct drag_law drag_hill_koch_ladd = {
    .name = "hill-koch-ladd",
    .what = "random arrays of spheres, from resolved flow; slow flow above all",
    .equations = "Hill01, Benyahia06",
    .function = "hill_koch_ladd",
    .eps_min = 0.36,
    .eps_max = 1.0,
    .Re_max = 200.0,
    .resistance = hill_koch_ladd,
};
