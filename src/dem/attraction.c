/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/attraction.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "dem/integrator.h"

double attraction_damp(const struct attraction *a, double R_star, double gap,
                       double closing, double per_mass, double dt)
{
    const double c = a->law->damping(a, R_star, gap);
    return c * implicit_drag_gain(2.0 * c * per_mass * dt) * closing;
}

double attraction_of_pair(const struct attraction *a, int material_i,
                          int material_j, double R_i, double R_j, double gap,
                          double closing, double per_mass, double dt)
{
    double F = 0.0;

    if (gap > a->range) return F;
    if (a->law->pair != NULL)
        F = a->law->pair(a, material_i, material_j, R_i, R_j, gap);
    if (a->law->damping != NULL)
        F += attraction_damp(a, R_i * R_j / (R_i + R_j), gap, closing, per_mass,
                             dt);
    return F;
}

double attraction_of_wall(const struct attraction *a, double R, double gap,
                          double closing, double per_mass, double dt)
{
    double F = 0.0;

    if (gap > a->range) return F;
    if (a->law->wall != NULL) F = a->law->wall(a, R, gap);
    if (a->law->damping != NULL)
        F += attraction_damp(a, R, gap, closing, per_mass, dt);
    return F;
}

/* --- van der waals -------------------------------------------------------- */

double van_der_waals_diameter(double D_i, double D_j)
{
    return D_i * D_j / (D_i + D_j);
}

double van_der_waals_force(double A, double D_star, double l)
{
    return A / (12.0 * l * l) * D_star; /* [LS 4.14] */
}

static double van_der_waals_pull(const struct attraction *a, double D_star,
                                 double gap)
{
    return -van_der_waals_force(a->strength, D_star, fmax(gap, a->closest));
}

static double van_der_waals_pair(const struct attraction *a, int of_i, int of_j,
                                 double R_i, double R_j, double gap)
{
    (void)of_i, (void)of_j;
    return van_der_waals_pull(a, van_der_waals_diameter(2.0 * R_i, 2.0 * R_j),
                              gap);
}

static double van_der_waals_wall(const struct attraction *a, double R,
                                 double gap)
{
    return van_der_waals_pull(a, 2.0 * R, gap);
}

const struct attraction_law van_der_waals = {.name = "van_der_waals",
                                             .pair = van_der_waals_pair,
                                             .wall = van_der_waals_wall,
                                             .parcel_power = 3};

/* --- capillary ------------------------------------------------------------ */

double capillary_mean(double R_i, double R_j)
{
    return 0.5 * (R_i + R_j);
}

double capillary_harmonic_mean(double R_i, double R_j)
{
    return 2.0 * R_i * R_j / (R_i + R_j);
}

double capillary_force(double tension, double R_star)
{
    return -2.0 * M_PI * R_star * tension; /* [LS 4.15] */
}

static double capillary_pair(const struct attraction *a, int of_i, int of_j,
                             double R_i, double R_j, double gap)
{
    (void)of_i, (void)of_j, (void)gap;
    return capillary_force(a->strength, a->harmonic
                                            ? capillary_harmonic_mean(R_i, R_j)
                                            : capillary_mean(R_i, R_j));
}

static double capillary_wall(const struct attraction *a, double R, double gap)
{
    (void)gap;
    return capillary_force(a->strength, 2.0 * R);
}

const struct attraction_law capillary = {.name = "capillary",
                                         .pair = capillary_pair,
                                         .wall = capillary_wall,
                                         .parcel_power = 1};

/* --- electrostatic -------------------------------------------------------- */

static const double eps_0 = 8.8541878128e-12; /* [F/m] of the vacuum */

double electrostatic_force(double q_i, double q_j, double eps_r, double l)
{
    return q_i * q_j / (4.0 * M_PI * eps_0 * eps_r * l * l); /* [LS 4.13] */
}

static double electrostatic_pair(const struct attraction *a, int of_i, int of_j,
                                 double R_i, double R_j, double gap)
{
    return electrostatic_force(a->charge[of_i], a->charge[of_j], a->strength,
                               R_i + R_j + gap);
}

const struct attraction_law electrostatic = {
    .name = "electrostatic", .pair = electrostatic_pair, .far_field = 1};
