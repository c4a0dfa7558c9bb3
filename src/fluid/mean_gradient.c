/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mean_gradient.c -- the mean pressure gradient of a flow through a periodic
 * box.
 *
 * The pressure p itself is periodic; in addition the pressure has a mean
 * gradient G, either given or chosen so that the mean superficial velocity is
 * the prescribed one. The flux through a face is linear in G, -m_f G . S, and
 * so is its mean over the box,
 *
 *   (1/V) sum phi d,
 *
 * so G is the difference of the prescribed and the present mean over the change
 * of the mean per unit of G.
 */
#include "fluid/pressure_system.h"

#include "base/vector.h"

int mean_gradient_exists(const struct fluid_options *o)
{
    for (int k = 0; k < 3; k++)
        if (o->mean_gradient[k] != 0.0 || o->keeps_flow[k]) return 1;
    return 0;
}

/* The G in direction k with which the predicted fluxes and the present p give
 * the prescribed mean flow. */
static double required_gradient(const struct fluid *fl, int k)
{
    const struct mesh *const m = fl->mesh;
    const struct pressure_system *const pressure = fl->pressure;
    double flow = 0.0, loss = 0.0, V = 0.0;

    for (int c = 0; c < m->n_cells; c++)
        V += m->V[c];
    for (int f = 0; f < m->n_internal; f++) {
        const double dp = fl->p[m->neighbour[f]] - fl->p[m->owner[f]];
        flow += (fl->phi[f] - pressure->conductance[f] * dp) * m->d[3 * f + k];
        loss += pressure->m_face[f] * m->S[3 * f + k] * m->d[3 * f + k];
    }
    if (loss == 0.0) return 0.0; /* one cell across: no periodic flow */
    return (flow - V * fl->options.mean_flow[k]) / loss;
}

void mean_gradient_add(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double *const G = fl->mean_gradient;

    for (int k = 0; k < 3; k++)
        if (fl->options.keeps_flow[k]) G[k] = required_gradient(fl, k);
    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] -= fl->pressure->m_face[f] * vector_dot(G, &m->S[3 * f]);
}
