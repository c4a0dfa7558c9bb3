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

double body_numbers_contact_mass(double C_v)
{
    return fmin(C_v, 0.5);
}

double body_numbers_crowding(double phi)
{
    return (1.0 + 2.0 * phi) / (1.0 - phi); /* [Lamb32] */
}

/* Beside a wall or another body the added mass is up to twice as large, and
 * what viscosity takes of a velocity up to 2.5 times. Among several bodies it
 * is that in the middle of a shell which they fill as a loose packing does. */
static const double beside = 2.0, friction_beside = 2.5, packed = 0.6;

/* K is what viscosity takes in the step of a change of 1 [-]. */
static double without_growth(double least, double K, double C_a, double rho_r)
{
    return fmax(least, 0.5 * (K + 1.0 + 2.0 * C_a - rho_r));
}

double body_numbers_virtual_mass(double least, double x, double rho_r,
                                 double C_a, int n)
{
    const double K = friction_beside * 4.5 * (x + sqrt(x));
    const double others = n > 2 ? body_numbers_crowding(packed) : beside;
    return without_growth(least, K, others * C_a, rho_r);
}

double body_numbers_virtual_spin(double least, double x, double rho_r,
                                 double C_a)
{
    const double root = sqrt(x);
    /* a sphere that spins moves no fluid but by viscosity */
    return without_growth(least, 15.0 * x + 5.0 * root / (1.0 + root),
                          beside * fmax(C_a - 0.5, 0.0), rho_r);
}
