/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deferred.c -- what a face takes from beyond its two cells.
 *
 * The rest of a convection scheme that looks upstream of the upstream cell, and
 * the part of the viscous stress that a link oblique to its face does not see:
 *
 *   mu grad u . S = mu (S.S / S.d) (u_N - u_P) + mu grad u . (S - d S.S / S.d)
 *
 * Both need slopes, so they are taken from the velocities known so far and put
 * on the right side, to one cell what is taken from the other.
 */
#include "fluid/piso.h"

#include <stddef.h>

int deferred_exists(const struct fluid *fl)
{
    return fl->options.convection->beyond != NULL || fl->mesh->oblique;
}

static void fill_slopes(struct fluid *fl, const double *u)
{
    const struct mesh *const m = fl->mesh;
    const struct slope_scheme *const s =
        fl->options.slope != NULL ? fl->options.slope : &slope_schemes[0];

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++)
            edge_velocity(fl, &fl->options.boundaries[i], f,
                          &fl->piso->u_edge[3 * (f - m->n_internal)]);
    }
    s->fill(m, u, fl->piso->u_edge, fl->piso->slope);
}

static double along(const double *slope, const double *x)
{
    return slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2];
}

/* What the scheme adds to component k at face f. */
static double beyond(const struct fluid *fl, const double *u, int f, int k)
{
    const struct mesh *const m = fl->mesh;
    const int o = m->owner[f], n = m->neighbour[f];
    const int with = fl->piso->carry[f] >= 0.0; /* from owner to neighbour */
    const double sign = with ? 1.0 : -1.0;
    const double step = sign * (u[3 * n + k] - u[3 * o + k]);
    const double *const slope = &fl->piso->slope[9 * (with ? o : n) + 3 * k];

    return fl->options.convection->beyond(step,
                                          sign * along(slope, &m->d[3 * f]),
                                          with ? 1.0 - m->w[f] : m->w[f]);
}

/* grad u . (S - d S.S / S.d) of component k, linear between the cells. */
static double oblique(const struct fluid *fl, const double rest[3], int f,
                      int k)
{
    const struct mesh *const m = fl->mesh;
    const double *const slope = fl->piso->slope;

    return m->w[f] * along(&slope[9 * m->owner[f] + 3 * k], rest) +
           (1.0 - m->w[f]) * along(&slope[9 * m->neighbour[f] + 3 * k], rest);
}

/* To one cell what is taken from the other. */
static void pass(struct fluid *fl, int f, int k, double force)
{
    fl->piso->b[3 * fl->mesh->owner[f] + k] += force;
    fl->piso->b[3 * fl->mesh->neighbour[f] + k] -= force;
}

static void add_beyond(struct fluid *fl, const double *u)
{
    fill_slopes(fl, u);
    for (int f = 0; f < fl->mesh->n_internal; f++)
        for (int k = 0; k < 3; k++)
            pass(fl, f, k,
                 -fl->options.rho * fl->piso->carry[f] * beyond(fl, u, f, k));
}

static void add_oblique(struct fluid *fl, const double *u)
{
    fill_slopes(fl, u);
    for (int f = 0; f < fl->mesh->n_internal; f++) {
        double rest[3];
        mesh_oblique_part(fl->mesh, f, rest);
        for (int k = 0; k < 3; k++)
            pass(fl, f, k, fl->options.mu * oblique(fl, rest, f, k));
    }
}

/* How many cells viscosity crosses in a step [-]. */
static double crossed(const struct fluid *fl, int c)
{
    const struct mesh *const m = fl->mesh;
    double link = 0.0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        link += fl->piso->link[m->cell_face[a]];
    return fl->options.mu * link / fl->piso->storage[c];
}

/* The velocity from which the oblique part is taken: what two steps continue
 * to, less and less of it where viscosity crosses cells within a step. All of
 * it there would overshoot from step to step on links that are more than 20
 * degrees oblique; and with short steps the order stays two. */
static const double *continued(const struct fluid *fl)
{
    double *const to = fl->piso->rhs; /* room that is free now */
    const double *const known = fl->piso->u_known, *const u = fl->u;

    if (known == NULL) return u;
    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double part = 1.0 / (1.0 + crossed(fl, c));
        for (int i = 3 * c; i < 3 * c + 3; i++)
            to[i] = u[i] + part * (known[i] - u[i]);
    }
    return to;
}

void deferred_add(struct fluid *fl)
{
    const double *const known = fl->piso->u_known;

    if (fl->options.convection->beyond != NULL)
        add_beyond(fl, known != NULL ? known : fl->u);
    if (fl->mesh->oblique) add_oblique(fl, continued(fl));
}
