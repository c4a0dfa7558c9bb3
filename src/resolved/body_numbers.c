/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_numbers.h"

#include <gsl/gsl_math.h>
#include <math.h>

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

double body_numbers_added_mass(double volume, double width)
{
    /* no shape has less than a sphere */
    return 0.5 * fmax(1.0, sqrt(6.0 * volume / (M_PI * width * width * width)));
}

/* Beside a wall or another body the added mass is up to twice as large, and
 * what viscosity takes of a velocity up to 2.5 times. */
static const double mass_beside = 2.0, friction_beside = 2.5;

/* K is what viscosity takes in the step of a change of 1 [-]. */
static double without_growth(double least, double K, double C_a, double rho_r)
{
    return fmax(least, 0.5 * (K + 1.0 + 2.0 * mass_beside * C_a - rho_r));
}

double body_numbers_virtual_mass(double least, double x, double rho_r,
                                 double C_a)
{
    const double K = friction_beside * 4.5 * (x + sqrt(x));
    return without_growth(least, K, C_a, rho_r);
}

double body_numbers_virtual_spin(double least, double x, double rho_r,
                                 double C_a)
{
    const double root = sqrt(x);
    /* a sphere that spins moves no fluid but by viscosity */
    return without_growth(least, 15.0 * x + 5.0 * root / (1.0 + root),
                          fmax(C_a - 0.5, 0.0), rho_r);
}

double body_numbers_impact_gain(double rho_r, double C_v, double steps)
{
    const double whole = rho_r + 0.5; /* with the added mass of a sphere */
    const double late = (C_v - 0.5) / whole; /* steps */
    return exp(0.5 * M_PI * M_PI / steps * late * sqrt((rho_r + C_v) / whole));
}
