/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boundary_face.c -- the velocity at boundary faces. */
#include "fluid/momentum_system.h"

#include <math.h>
#include <stddef.h>

#include "base/vector.h"
#include "fluid/piso.h"
#include "fluid/time_levels.h"

/* The velocity of what enters is the flux over the area times eps; backflow
 * through an outlet enters with zero velocity. */
void boundary_face_velocity(const struct fluid *fl, const struct boundary *b,
                            int j, int f, double u[3])
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    const double *const S = &fl->mesh->S[3 * f], SS = fl->geometry->SS[f];
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

void boundary_face_inlet_fluxes(const struct fluid *fl, double *phi)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct boundary *const b = &fl->options.boundaries[i];
        const struct patch *const p = &m->patches[i];
        if (b->kind != BOUNDARY_INLET) continue;
        const double U = boundary_inlet_velocity(b, fl->t);
        for (int j = 0; j < p->n; j++) {
            const double *const S = &m->S[3 * (p->first + j)];
            const double profile = boundary_inlet_profile(b, j, fl->t);
            phi[p->first + j] = -U * profile * vector_length(S);
        }
    }
}
