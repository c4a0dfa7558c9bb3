/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/boundary.h"

#include <stdlib.h>

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

double boundary_inlet_profile(const struct boundary *b, int j, double t)
{
    if (b->varying != NULL) return b->varying(b, j, t);
    return b->profile != NULL ? b->profile[j] : 1.0;
}

const double *boundary_wall_velocity(const struct boundary *b, int j)
{
    return b->walls != NULL ? &b->walls[3 * j] : b->wall;
}

void boundary_release(struct boundary *b)
{
    free(b->series);
    if (b->release != NULL)
        b->release(b);
    else
        free(b->memory);
}
