/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/boundary.h"

double boundary_inlet_velocity(const struct boundary *b, double t)
{
    const double *const x = b->time, *const U = b->velocity;
    int i = 0;

    if (t <= x[0]) return U[0];
    while (i < b->n_points - 1 && t > x[i + 1])
        i++;
    if (i == b->n_points - 1) return U[i];
    return U[i] + (U[i + 1] - U[i]) * (t - x[i]) / (x[i + 1] - x[i]);
}

double boundary_parabola(double a, double b)
{
    const double square = a * a + a * b + b * b; /* (b^3 - a^3) / (b - a) */

    return 3.0 * (a + b) - 2.0 * square; /* mean of 6 s (1 - s) */
}
