/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_numbers.h"

double body_numbers_reynolds(double rho, double V, double L, double mu)
{
    return rho * V * L / mu; /* [EW18 6] */
}

double body_numbers_inverse_froude(double g, double L, double V)
{
    return g * L / (V * V); /* [EW18 7] */
}

double body_numbers_density_ratio(double rho_p, double rho)
{
    return rho_p / rho; /* [EW18 8] */
}

double body_numbers_stokes(double rho_r, double Re)
{
    return rho_r * Re / 18.0; /* [EW18 9] */
}
