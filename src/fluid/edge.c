/* SPDX-License-Identifier: GPL-3.0-or-later */
/* edge.c -- the velocity on the boundary. */
#include "fluid/piso.h"

#include <math.h>
#include <stddef.h>

static double dot3(const double *a, const double *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Fluid enters with the velocity that carries the flux through the fluid's
 * share of the face; what flows back in through an outlet enters at rest. */
void edge_velocity(const struct fluid *fl, const struct boundary *b, int f,
                   double u[3])
{
    const double *const S = &fl->mesh->S[3 * f];
    const int c = fl->mesh->owner[f];
    const double *const inside = &fl->u[3 * c];
    const double phi = fl->piso->carry[f];

    for (int k = 0; k < 3; k++)
        if (b->kind == BOUNDARY_INLET)
            u[k] = phi * S[k] / (fl->eps[c] * dot3(S, S));
        else if (b->kind == BOUNDARY_OUTLET)
            u[k] = phi >= 0.0 ? inside[k] : 0.0;
        else if (b->kind == BOUNDARY_SLIP)
            u[k] = inside[k] - dot3(inside, S) * S[k] / dot3(S, S);
        else
            u[k] = b->wall[k];
}

void edge_inlet_fluxes(const struct fluid *fl, double *phi)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct boundary *const b = &fl->options.boundaries[i];
        const struct patch *const p = &m->patches[i];
        if (b->kind != BOUNDARY_INLET) continue;
        const double U = boundary_inlet_velocity(b, fl->t);
        for (int j = 0; j < p->n; j++) {
            const double *const S = &m->S[3 * (p->first + j)];
            const double share = b->profile != NULL ? b->profile[j] : 1.0;
            phi[p->first + j] = -U * share * sqrt(dot3(S, S));
        }
    }
}
