/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/drag_laws/coefficient.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "coupling/drag.h"

double coefficient_of_force(double F, double rho_f, double d, double eps,
                            double u_r)
{
    const double U = eps * u_r;

    return 8.0 * F / (M_PI * rho_f * d * d * U * fabs(U)); /* [EW18 26] */
}

double coefficient_reynolds(double eps, double rho_f, double mu, double d,
                            double u_r)
{
    return drag_reynolds(rho_f, mu, d, eps * fabs(u_r)); /* [EW18 27, A.1] */
}
