/* SPDX-License-Identifier: GPL-3.0-or-later */
/* beetstra.c -- drag in random arrays of spheres, fitted to lattice-Boltzmann
 * simulations for solid fractions to 0.6 and Re to 1000 [Beetstra07].
 *
 * Beetstra's factor F belongs to the drag without the mean pressure gradient
 * and to the superficial slip, 3 pi mu d eps_f u_r F. EW18 prints
 * 3 pi mu d u_r g with g = F, and uses it as the whole force [EW18 A.5]: it is,
 * because the whole force is the drag over eps_f.
 */
#include "coupling/drag_laws/beetstra.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>

#include "coupling/drag_laws/factor.h"

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

static double beetstra(double eps_f, double rho_f, double mu, double d,
                       double u_r)
{
    return drag_by_factor(drag_beetstra_factor, eps_f, rho_f, mu, d, u_r);
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
    .function = "beetstra",
    .eps_min = 0.4,
    .eps_max = 1.0,
    .Re_max = 1e3,
    .resistance = beetstra,
};
