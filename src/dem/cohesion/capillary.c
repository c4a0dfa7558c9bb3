/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/cohesion/capillary.h"

#include <gsl/gsl_math.h>

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

const struct attraction_law capillary = {
    .name = "capillary", .pair = capillary_pair, .wall = capillary_wall};
