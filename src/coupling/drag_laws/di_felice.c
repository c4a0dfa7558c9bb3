/* SPDX-License-Identifier: GPL-3.0-or-later */
/* di_felice.c -- the drag of one sphere at the superficial slip, times a power
 * of the fluid fraction that depends on Re,
 *
 *   F_d = (1/2) C_d rho_f (pi d^2 / 4) (eps_f u_r)^2 eps_f^-chi   [EW18 A.2]
 *
 * [DiFelice94]. This is the drag without the mean pressure gradient: in slow
 * flow a suspension then settles with eps_f^4.7 of the speed of one sphere,
 * and measured is 4.65.
 *
 * EW18 prints the square of the interstitial slip instead, and uses the result
 * as the whole force. The law "di-felice-printed" is that one; it is larger by
 * 1 / eps_f, and settles with the power 5.7.
 */
#include "coupling/drag_laws/di_felice.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

double drag_di_felice_exponent(double Re)
{
    const double a = 1.5 - log10(Re);

    return Re > 0.0 ? 3.7 - 0.65 * exp(-0.5 * a * a) : 3.7; /* [EW18 A.3] */
}

/* [EW18 A.2, A.4] over Stokes' law. */
static double di_felice_factor(double eps_f, double Re)
{
    return drag_sphere(Re) * pow(eps_f, -drag_di_felice_exponent(Re));
}

static double di_felice(double eps_f, double rho_f, double mu, double d,
                        double u_r)
{
    return drag_by_factor(di_felice_factor, eps_f, rho_f, mu, d, u_r);
}

double drag_di_felice_force(double eps, double rho_f, double mu, double d,
                            double u_r)
{
    return M_PI / 6.0 * d * d * d * di_felice(eps, rho_f, mu, d, u_r) * u_r;
}

const struct drag_law drag_di_felice = {
    .name = "di-felice",
    .what = "one sphere at the superficial slip, times a power of eps_f",
    .equations = "EW18 A.1-A.4",
    .function = "di_felice",
    .eps_min = 0.4,
    .eps_max = 1.0,
    .Re_max = 1e4,
    .resistance = di_felice,
};

/* The whole force is (1/2) C_d rho_f (pi d^2 / 4) u_r^2 eps_f^-chi, so its
 * drag is eps_f times that: 1 / eps_f times Di Felice's. */
static double di_felice_printed_factor(double eps_f, double Re)
{
    return di_felice_factor(eps_f, Re) / eps_f;
}

static double di_felice_printed(double eps_f, double rho_f, double mu, double d,
                                double u_r)
{
    return drag_by_factor(di_felice_printed_factor, eps_f, rho_f, mu, d, u_r);
}

const struct drag_law drag_di_felice_printed = {
    .name = "di-felice-printed",
    .what = "as EW18 prints Di Felice's law: 1 / eps_f times it",
    .equations = "EW18 A.1-A.4",
    .function = "di_felice_printed",
    .eps_min = 0.4,
    .eps_max = 1.0,
    .Re_max = 1e4,
    .resistance = di_felice_printed,
};
