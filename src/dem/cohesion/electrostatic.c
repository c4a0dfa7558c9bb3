/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/cohesion/electrostatic.h"

#include <gsl/gsl_math.h>
#include <stddef.h>

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

const struct attraction_law electrostatic = {.name = "electrostatic",
                                             .pair = electrostatic_pair};
