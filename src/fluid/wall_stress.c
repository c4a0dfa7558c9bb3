/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/wall_stress.h"

#include <math.h>

#include "base/vector.h"
#include "mesh/measures.h"

int wall_stress_is_wall(const struct fluid *fl, int patch)
{
    const enum boundary_kind kind = fl->options.boundaries[patch].kind;
    return kind == BOUNDARY_NO_SLIP || kind == BOUNDARY_SLIP;
}

/* At a slip wall only the normal part acts. */
static void viscous_force(const struct fluid *fl, const struct boundary *b,
                          int j, int f, double force[3])
{
    const struct mesh *const m = fl->mesh;
    const double *const S = &m->S[3 * f], *const u = &fl->u[3 * m->owner[f]];
    const double SS = vector_dot(S, S), mu = fl->options.mu;
    const double D = mu * SS / vector_dot(S, &m->d[3 * f]);
    double turned[3];

    if (b->kind == BOUNDARY_SLIP) {
        for (int k = 0; k < 3; k++)
            force[k] = D * vector_dot(u, S) * S[k] / SS;
        return;
    }
    vector_cross(b->rotation, S, turned);
    for (int k = 0; k < 3; k++)
        force[k] =
            D * (u[k] - boundary_wall_velocity(b, j)[k]) + mu * turned[k];
}

struct wall_stress wall_stress(const struct fluid *fl, int patch, int j)
{
    const struct mesh *const m = fl->mesh;
    const int f = m->patches[patch].first + j;
    const double *const S = &m->S[3 * f];
    struct wall_stress w = {.area = vector_length(S)};
    double x[3];

    mesh_face_middle(m, f, x);
    const double p = fl->p_face[f] + vector_dot(fl->mean_gradient, x);
    viscous_force(fl, &fl->options.boundaries[patch], j, f, w.viscous);
    const double normal = vector_dot(w.viscous, S) / (w.area * w.area);
    for (int k = 0; k < 3; k++) {
        w.pressure[k] = p * S[k];
        w.shear[k] = (w.viscous[k] - normal * S[k]) / w.area;
    }
    const double y = vector_dot(&m->d[3 * f], S) / w.area;
    const double rho = fl->options.rho, mu = fl->options.mu;
    if (mu > 0.0) w.y_plus = y * sqrt(vector_length(w.shear) * rho) / mu;
    return w;
}
