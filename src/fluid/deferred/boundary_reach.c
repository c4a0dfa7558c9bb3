/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/deferred/boundary_reach.h"

#include <stddef.h>

#include "base/alloc.h"
#include "fluid/deferred.h"

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

void boundary_reach_gradient(const struct fluid *fl, const double *u,
                             const double *u_b, double *slope)
{
    const struct velocity_gradient_scheme *const s =
        fl->options.velocity_gradient != NULL ? fl->options.velocity_gradient
                                              : velocity_gradient_schemes[0];
    const double *const reach =
        fl->deferred != NULL ? fl->deferred->reach : NULL;

    s->fill(fl->mesh, reach, u, u_b, slope);
}
