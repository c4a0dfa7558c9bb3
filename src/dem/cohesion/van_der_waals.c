/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/cohesion/van_der_waals.h"

#include <math.h>

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
                                             .wall = van_der_waals_wall};
