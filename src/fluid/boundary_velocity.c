/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/piso.h"

#include <math.h>

/* The velocity of the cell without its component normal to the wall. */
static void tangential_part(const double u[3], const double S[3], double SS,
                            double to[3])
{
    const double through = u[0] * S[0] + u[1] * S[1] + u[2] * S[2];

    for (int k = 0; k < 3; k++)
        to[k] = u[k] - through * S[k] / SS;
}

static void velocity_at(const struct fluid *fl, const struct boundary *b, int j,
                        int f, double to[3])
{
    const struct mesh *const m = fl->mesh;
    const int c = m->owner[f];
    const double *const S = &m->S[3 * f], *const u = &fl->u[3 * c];
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];

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
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++)
            velocity_at(fl, &fl->options.boundaries[i], f - p->first, f,
                        &u_b[3 * (f - m->n_internal)]);
    }
}

void fluid_velocity_gradient(const struct fluid *fl, const double *u,
                             const double *u_b, double *slope)
{
    const struct velocity_gradient_scheme *const s =
        fl->options.velocity_gradient != NULL ? fl->options.velocity_gradient
                                              : velocity_gradient_schemes[0];

    s->fill(fl->mesh, fl->geometry->reach, u, u_b, slope);
}

/* The mean over an inlet, whose profile counts as 1 where it is that up to
 * rounding. */
static double inlet_velocity(const struct fluid *fl, const struct boundary *b,
                             const struct patch *p)
{
    double sum = 0.0, surface = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double *const S = &fl->mesh->S[3 * (p->first + j)];
        const double area = sqrt(S[0] * S[0] + S[1] * S[1] + S[2] * S[2]);
        sum += area * boundary_inlet_share(b, j, fl->t);
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
