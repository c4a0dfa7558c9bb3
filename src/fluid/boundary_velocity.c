/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/piso.h"

#include <math.h>

#include "base/alloc.h"
#include "base/vector.h"

/* to = the velocity of the cell without its component normal to the wall. */
static void tangential_part(const double u[3], const double S[3], double SS,
                            double to[3])
{
    const double through = vector_dot(u, S);

    for (int k = 0; k < 3; k++)
        to[k] = u[k] - through * S[k] / SS;
}

static void velocity_at(const struct fluid *fl, const struct boundary *b, int j,
                        int f, double to[3])
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
        velocity_at(fl, b, j, f, &u_b[3 * (f - fl->mesh->n_internal)]);
}

double *boundary_reach(const struct mesh *m, const struct boundary *b)
{
    if (!m->skewed) return NULL;
    double *const reach = alloc_doubles(3 * (m->n_faces - m->n_internal));

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        const int foot = b[i].kind == BOUNDARY_SLIP ||
                         b[i].kind == BOUNDARY_OUTLET || b[i].walls != NULL;
        for (int f = p->first; f < p->first + p->n; f++) {
            double off[3];
            const int moved = mesh_misses_middle(m, f, off) && foot;
            for (int k = 0; k < 3; k++)
                reach[3 * (f - m->n_internal) + k] =
                    m->d[3 * f + k] - (moved ? off[k] : 0.0);
        }
    }
    return reach;
}

void fluid_velocity_gradient(const struct fluid *fl, const double *u,
                             const double *u_b, double *slope)
{
    const struct velocity_gradient_scheme *const s =
        fl->options.velocity_gradient != NULL ? fl->options.velocity_gradient
                                              : velocity_gradient_schemes[0];

    s->fill(fl->mesh, fl->geometry->reach, u, u_b, slope);
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
