/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/vorticity.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "fluid/deferred/boundary_reach.h"

struct vorticity *vorticity_create(struct simulation *sim, const char *name)
{
    const struct mesh *const m = sim->mesh;
    struct vorticity *const v = alloc_zeroed(1, sizeof *v);

    v->u_b = alloc_doubles(3 * (m->n_faces - m->n_internal));
    v->gradient = alloc_doubles(9 * m->n_cells);
    v->curl = alloc_doubles(3 * m->n_cells);
    v->at = alloc_doubles(3 * sim->particles->capacity);
    particles_attach(sim->particles, name, "1/s", v->at, 3);
    return v;
}

void vorticity_free(void *memory)
{
    struct vorticity *const v = memory;

    if (v == NULL) return;
    free(v->u_b);
    free(v->gradient);
    free(v->curl);
    free(v->at);
    free(v);
}

void vorticity_update(void *memory, struct simulation *sim)
{
    struct vorticity *const v = memory;
    const struct fluid *const fl = sim->fluid;

    fluid_boundary_velocity(fl, v->u_b);
    boundary_reach_gradient(fl, fl->u, v->u_b, v->gradient);
    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double *const g =
            &v->gradient[9 * c]; /* d u_k/d x_j at 3 k + j */
        v->curl[3 * c] = g[7] - g[5];
        v->curl[3 * c + 1] = g[2] - g[6];
        v->curl[3 * c + 2] = g[3] - g[1];
    }
    averaging_gather(sim->averaging, 3, v->curl, v->at);
}

void vorticity_relative_spin(const struct vorticity *v,
                             const struct particles *ps, int i, double Omega[3])
{
    const double *const curl = &v->at[3 * i];

    Omega[0] = ps->wx[i] - 0.5 * curl[0];
    Omega[1] = ps->wy[i] - 0.5 * curl[1];
    Omega[2] = ps->wz[i] - 0.5 * curl[2];
}
