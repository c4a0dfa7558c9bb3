/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fluidization.c -- minimum fluidization. [EW18 22] is
 *
 *   (1 - eps) (rho_s - rho_f) g = beta u_mf,
 *
 * printed with the densities the other way round and without saying of which
 * velocity beta is the coefficient. u_mf is superficial, so beta is Ergun's
 * pressure drop over it, beta = 150 (1 - eps)^2 mu / (eps^3 d^2) +
 * 1.75 (1 - eps) rho_f u_mf / (eps^3 d).
 */
#include "coupling/drag_laws/fluidization.h"

#include <math.h>

/* With a = beta of slow flow and b u_mf the rest, the positive root of
 * b u^2 + a u = w, without the difference of two large numbers. */
double fluidization_velocity(double eps_mf, double rho_f, double rho_s,
                             double mu, double d, double g)
{
    const double s = 1.0 - eps_mf, e3 = eps_mf * eps_mf * eps_mf;
    const double a = 150.0 * s * s * mu / (e3 * d * d);
    const double b = 1.75 * s * rho_f / (e3 * d);
    const double w = s * (rho_s - rho_f) * g;

    return w > 0.0 ? 2.0 * w / (a + sqrt(a * a + 4.0 * b * w)) : 0.0;
}
