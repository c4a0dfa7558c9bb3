/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boundary.c -- the velocity and the flux that the condition of a patch gives
 * its faces. */
#include "fluid/boundary.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "fluid/piso.h"
#include "fluid/systems.h"

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

/* --- boundary velocity ---------------------------------------------------- */

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
    const double *const S = mesh_S(m, f), *const u = &fl->u[3 * c];
    const double SS = piso_square(fl, f);

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

    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        boundary_velocity_at(fl, b, j, f, &u_b[3 * (f - m->n_internal)]);
    for (int f = fl->faces->n; f < m->n_faces; f++)
        memcpy(&u_b[3 * (f - m->n_internal)], &fl->u[3 * m->owner[f]],
               3 * sizeof *u_b);
}

/* The mean velocity over an inlet [m/s]. A mean of the profile that is 1 within
 * rounding counts as 1. */
static double inlet_velocity(const struct fluid *fl, const struct boundary *b,
                             const struct patch *p)
{
    double sum = 0.0, surface = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double area = vector_length(mesh_S(fl->mesh, p->first + j));
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

/* The velocity of what enters is the flux over the area times eps; backflow
 * through an outlet enters with zero velocity. */
void boundary_face_velocity(const struct fluid *fl, const struct boundary *b,
                            int j, int f, double u[3])
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const double *const S = mesh_S(fl->mesh, f), SS = piso_square(fl, f);
    const int c = fl->mesh->owner[f];
    const double *const inside = &fl->u[3 * c];
    const double phi = fl->levels->convecting_flux[f];

    if (b->kind == BOUNDARY_INLET || (b->enters && phi < 0.0))
        vector_along(zero, phi / (fl->eps[c] * SS), S, u);
    else if (b->kind == BOUNDARY_OUTLET)
        vector_along(phi >= 0.0 ? inside : zero, 0.0, S, u);
    else if (b->kind == BOUNDARY_SLIP)
        vector_along(inside, -vector_dot(inside, S) / SS, S, u);
    else
        vector_along(boundary_wall_velocity(b, j), 0.0, S, u);
}

/* Sets the flux [m^3/s] of each inlet face from the velocity of the case. */
void boundary_face_inlet_fluxes(const struct fluid *fl, double *phi)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct boundary *const b = &fl->options.boundaries[i];
        const struct patch *const p = &m->patches[i];
        if (b->kind != BOUNDARY_INLET) continue;
        const double U = boundary_inlet_velocity(b, fl->t);
        for (int j = 0; j < p->n; j++) {
            const double *const S = mesh_S(m, p->first + j);
            const double profile = boundary_inlet_profile(b, j, fl->t);
            phi[p->first + j] = -U * profile * vector_length(S);
        }
    }
}
