/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/piso.h"

#include <math.h>

#include "base/vector.h"

/* to = the velocity of the cell without its component normal to the wall. */
static void tangential_part(const double u[3], const double S[3], double SS,
                            double to[3])
{
    const double through = vector_dot(u, S);

    for (int k = 0; k < 3; k++)
        to[k] = u[k] - through * S[k] / SS;
}

static void boundary_velocity_at(const struct fluid *fl,
                                 const struct boundary *b, int j, int f,
                                 double to[3])
{
    const struct mesh *const m = fl->mesh;
    const int c = m->owner[f];
    const double *const S = &m->S[3 * f], *const u = &fl->u[3 * c];
    const double SS = fl->geometry->SS[f];

    if (b->kind == BOUNDARY_SLIP) {
        tangential_part(u, S, SS, to);
        return;
    }
    const int enters =
        b->kind == BOUNDARY_INLET || (b->enters && fl->phi[f] < 0.0);
    for (int k = 0; k < 3; k++)
        to[k] = b->kind == BOUNDARY_NO_SLIP ? boundary_wall_velocity(b, j)[k]
                : enters ? fl->phi[f] * S[k] / (SS * fl->eps[c])
                         : u[k];
}

void fluid_boundary_velocity(const struct fluid *fl, double *u_b)
{
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        boundary_velocity_at(fl, b, j, f, &u_b[3 * (f - fl->mesh->n_internal)]);
}

/* The mean velocity over an inlet [m/s]. A mean of the profile that is 1 within
 * rounding counts as 1. */
static double inlet_velocity(const struct fluid *fl, const struct boundary *b,
                             const struct patch *p)
{
    double sum = 0.0, surface = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double area = vector_length(&fl->mesh->S[3 * (p->first + j)]);
        sum += area * boundary_inlet_profile(b, j, fl->t);
        surface += area;
    }
    const int is_one = fabs(sum - surface) <= 1e-12 * surface;
    return (is_one ? 1.0 : sum / surface) * boundary_inlet_velocity(b, fl->t);
}

double fluid_inlet_velocity(const struct fluid *fl)
{
    for (int i = 0; i < fl->mesh->n_patches; i++)
        if (fl->options.boundaries[i].kind == BOUNDARY_INLET)
            return inlet_velocity(fl, &fl->options.boundaries[i],
                                  &fl->mesh->patches[i]);
    return 0.0;
}
