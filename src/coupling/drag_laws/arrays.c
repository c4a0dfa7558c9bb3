/* SPDX-License-Identifier: GPL-3.0-or-later */
/* arrays.c -- laws fitted to simulations that resolve the flow through arrays
 * of spheres, each as a factor to Stokes' law (drag.h). */
#include "coupling/drag.h"

#include <gsl/gsl_math.h>
#include <math.h>

/* --- Hill, Koch and Ladd -------------------------------------------------- */

/* Random arrays of spheres from lattice-Boltzmann simulations [Hill01], in the
 * form that covers all solid fractions and Reynolds numbers [Benyahia06].
 *
 * F is the whole force over Stokes' law at the superficial slip, and their Re
 * is that of the radius, half of ours. */

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

/* Force in slow flow over Stokes' law [-] at the solids fraction s, as Re
 * goes to 0. */
static double F_0(double s)
{
    return slow_flow(s, numerator(s, 17.14) /
                            (1.0 + s * (0.681 + s * (-8.48 + s * 8.16))));
}

/* Coefficient [-] of the square of Re in slow flow, at the solids fraction
 * s. */
static double F_1(double s)
{
    return s <= 0.1 ? sqrt(2.0 / s) / 40.0 : 0.11 + 0.00051 * exp(11.6 * s);
}

/* Force [-] at Re = 0 on the straight line of fast flow, at s. */
static double F_2(double s)
{
    return slow_flow(s, numerator(s, 17.89) /
                            (1.0 + s * (0.681 + s * (-11.03 + s * 15.41))));
}

/* Slope [-] of the force with Re in fast flow, at the solids fraction s. */
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

const struct drag_law drag_hill_koch_ladd = {
    .name = "hill-koch-ladd",
    .what = "random arrays of spheres, from resolved flow; slow flow above all",
    .equations = "Hill01, Benyahia06",
    .function = "hill_koch_ladd_factor",
    .eps_min = 0.36,
    .eps_max = 1.0,
    .Re_max = 200.0,
    .factor = hill_koch_ladd_factor,
};

/* --- Beetstra ------------------------------------------------------------- */

/* Drag in random arrays of spheres, fitted to lattice-Boltzmann
 * simulations for solid fractions to 0.6 and Re to 1000 [Beetstra07].
 *
 * Beetstra's factor F belongs to the drag without the mean pressure gradient
 * and to the superficial slip, 3 pi mu d eps_f u_r F. EW18 prints
 * 3 pi mu d u_r g with g = F, and uses it as the whole force [EW18 A.5]: it is,
 * because the whole force is the drag over eps_f. */

/* [EW18 A.6]: Carman's packed bed, the dilute limit, and inertia. With
 * Re^0.157 for Re Re^-0.343 the last term is also good at Re = 0. */
double drag_beetstra_factor(double eps, double Re)
{
    const double s = 1.0 - eps, e2 = eps * eps;
    const double slow = 10.0 * s / e2 + e2 * (1.0 + 1.5 * sqrt(s));

    if (Re <= 0.0) return slow;
    return slow +
           0.413 / (24.0 * e2) *
               (Re * (1.0 / eps + 3.0 * eps * s) + 8.4 * pow(Re, 1.0 - 0.343)) /
               (1.0 + pow(10.0, 3.0 * s) * pow(Re, -0.5 - 2.0 * s));
}

double drag_beetstra_force(double eps, double rho_f, double mu, double d,
                           double u_r)
{
    const double Re = drag_reynolds(rho_f, mu, d, eps * u_r); /* [EW18 A.1] */

    return 3.0 * M_PI * mu * d * u_r * drag_beetstra_factor(eps, Re);
}

const struct drag_law drag_beetstra = {
    .name = "beetstra",
    .what = "random arrays of spheres, from resolved flow",
    .equations = "EW18 A.5, A.6",
    .function = "drag_beetstra_factor",
    .eps_min = 0.4,
    .eps_max = 1.0,
    .Re_max = 1e3,
    .factor = drag_beetstra_factor,
};

/* --- Tenneti -------------------------------------------------------------- */

/* Random arrays of spheres, from simulations with immersed
 * boundaries [Tenneti11].
 *
 * Their factor,
 *
 *   F = F_isolated / (1 - s)^3 + 5.81 s / (1 - s)^3 + 0.48 s^(1/3) / (1 - s)^4
 *       + s^3 Re (0.95 + 0.61 s^3 / (1 - s)^2),
 *
 * is the whole force over Stokes' law at the superficial slip: at s = 0.4 and
 * Re = 0 it is 18.1, and Carman's whole force is 10 s / (1 - s)^3 = 18.5. */

static double tenneti_factor(double eps_f, double Re)
{
    const double s = 1.0 - eps_f, e3 = gsl_pow_3(eps_f), s3 = gsl_pow_3(s);

    return eps_f * (drag_sphere(Re) / e3 + 5.81 * s / e3 +
                    0.48 * cbrt(s) / (e3 * eps_f) +
                    s3 * Re * (0.95 + 0.61 * s3 / (eps_f * eps_f)));
}

const struct drag_law drag_tenneti = {
    .name = "tenneti",
    .what = "random arrays of spheres, from resolved flow to Re = 300",
    .equations = "Tenneti11",
    .function = "tenneti_factor",
    .eps_min = 0.5,
    .eps_max = 0.9,
    .Re_min = 0.01,
    .Re_max = 300.0,
    .factor = tenneti_factor,
};

/* --- Cello ---------------------------------------------------------------- */

/* A fit to simulations of several authors over all fluid fractions
 * [Cello10], here for spheres of one size,
 *
 *   F = K_1 + K_2 eps_f^4 + K_3 (1 - eps_f^4),
 *   K_0 = (1 - eps_f)/(1 + 3 eps_f).
 *
 * Its last term has a pole, at Re = 1250 in a bed and above that elsewhere.
 * From Re = 1000 on, outside of its range, the drag coefficient is therefore
 * held, and F grows with Re. */

static const double last_Re = 1000.0;

/* Force over Stokes' law [-] in slow flow; K_0 is a function of eps_f alone. */
static double K_1(double eps_f, double K_0)
{
    return (1.0 + 128.0 * K_0 + 715.0 * K_0 * K_0) /
           (eps_f * eps_f * (1.0 + 49.5 * K_0));
}

/* Growth of the force with Re [-] for a single sphere. */
static double K_2(double Re)
{
    return (1.0 + 0.130 * Re + 6.66e-4 * Re * Re) /
               (1.0 + 3.42e-2 * Re + 6.92e-6 * Re * Re) -
           1.0;
}

/* Growth of the force with Re [-] in a dense bed, at eps_f. */
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

const struct drag_law drag_cello = {
    .name = "cello",
    .what = "a fit to several resolved simulations, Re to 1000",
    .equations = "Cello10",
    .function = "cello_factor",
    .eps_min = 0.36,
    .eps_max = 1.0,
    .Re_max = 1e3,
    .factor = cello_factor,
};
