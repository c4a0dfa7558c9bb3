/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deferred_correction.c -- deferred correction.
 *
 * To the equations of piso.h, which link a cell to its neighbours alone, this
 * file adds
 *
 *   - the explicit part of a convection scheme of second order, by the gradient
 *     of the upwind cell;
 *   - the non-orthogonal part of the viscous stress,
 *       mu grad u . S = mu (S.S / S.d) (u_N - u_P)
 *                       + mu grad u . (S - d S.S / S.d);
 *   - what skewness.c computes where the line between two centres misses that
 *     of their face.
 *
 * The first two need velocity gradients, so they are computed from the
 * velocities known so far and added to the right-hand sides of the two cells
 * with opposite signs.
 */
#include "fluid/deferred.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/momentum_system.h"
#include "fluid/piso.h"
#include "fluid/pressure_system.h"
#include "fluid/deferred/boundary_reach.h"
#include "fluid/deferred/skewness.h"
#include "fluid/time_levels.h"

static void fill_velocity_gradients(struct deferred *d, const struct fluid *fl,
                                    const double *u)
{
    const struct mesh *const m = fl->mesh;

    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        boundary_face_velocity(fl, b, j, f,
                               &d->u_boundary[3 * (f - m->n_internal)]);
    boundary_reach_gradient(fl, u, d->u_boundary, d->slope);
}

/* The explicit part of the convection scheme for component k at face f [m/s].
 */
static double explicit_part(const struct deferred *d, const struct fluid *fl,
                            const double *u, int f, int k)
{
    const struct mesh *const m = fl->mesh;
    const int o = m->owner[f], n = m->neighbour[f];
    const int with =
        fl->levels->convecting_flux[f] >= 0.0; /* from owner to neighbour */
    const double sign = with ? 1.0 : -1.0;
    const double step = sign * (u[3 * n + k] - u[3 * o + k]);
    const double *const slope = &d->slope[9 * (with ? o : n) + 3 * k];

    return fl->options.convection->deferred(
        step, sign * vector_dot(slope, &m->d[3 * f]),
        with ? 1.0 - m->w[f] : m->w[f]);
}

/* grad u . (S - d S.S / S.d) of component k, linear between the cells. */
static double non_orthogonal(const struct deferred *d, const struct fluid *fl,
                             const double oblique[3], int f, int k)
{
    const struct mesh *const m = fl->mesh;
    const double *const slope = d->slope;

    return m->w[f] * vector_dot(&slope[9 * m->owner[f] + 3 * k], oblique) +
           (1.0 - m->w[f]) *
               vector_dot(&slope[9 * m->neighbour[f] + 3 * k], oblique);
}

/* Adds a flux to one cell and subtracts it from the other. */
static void add_to_both_cells(struct fluid *fl, int f, int k, double force)
{
    fl->momentum->b[3 * fl->mesh->owner[f] + k] += force;
    fl->momentum->b[3 * fl->mesh->neighbour[f] + k] -= force;
}

static void add_explicit_part(struct deferred *d, struct fluid *fl,
                              const double *u)
{
    fill_velocity_gradients(d, fl, u);
    for (int f = 0; f < fl->mesh->n_internal; f++)
        for (int k = 0; k < 3; k++)
            add_to_both_cells(fl, f, k,
                              -fl->options.rho *
                                  fl->levels->convecting_flux[f] *
                                  explicit_part(d, fl, u, f, k));
}

static void add_non_orthogonal(struct deferred *d, struct fluid *fl,
                               const double *u)
{
    fill_velocity_gradients(d, fl, u);
    for (int f = 0; f < fl->mesh->n_internal; f++) {
        double oblique[3];
        mesh_oblique_part(fl->mesh, f, oblique);
        for (int k = 0; k < 3; k++)
            add_to_both_cells(fl, f, k,
                              fl->options.mu *
                                  non_orthogonal(d, fl, oblique, f, k));
    }
}

/* mu times the sum of S.S / S.d over the faces of a cell, over its coefficient
 * of the time derivative [-]: 6 nu dt / h^2 for equal cubes. */
static double diffusion_number(const struct fluid *fl, int c)
{
    const struct mesh *const m = fl->mesh;
    double link = 0.0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        link += fl->geometry->face_coefficient[m->cell_face[a]];
    return fl->options.mu * link / fl->levels->ddt[c];
}

/* The velocity used in the non-orthogonal part: extrapolated from two steps,
 * with an extrapolation that decreases where viscous diffusion crosses cells
 * within a step. Full extrapolation would be unstable there on links with an
 * angle of more than 20 degrees; with short steps the order in time is still
 * two. */
static const double *extrapolated(const struct fluid *fl)
{
    double *const to =
        fl->momentum->rhs; /* work space that is not in use here */
    const double *const known = fl->levels->u_known, *const u = fl->u;

    if (known == NULL) return u;
    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double part = 1.0 / (1.0 + diffusion_number(fl, c));
        for (int i = 3 * c; i < 3 * c + 3; i++)
            to[i] = u[i] + part * (known[i] - u[i]);
    }
    return to;
}

void deferred_add_to_momentum(struct deferred *d, struct fluid *fl)
{
    const double *const known =
        fl->levels->u_known != NULL ? fl->levels->u_known : fl->u;

    if (fl->options.convection->deferred != NULL)
        add_explicit_part(d, fl, known);
    if (fl->mesh->oblique || fl->mesh->skewed)
        add_non_orthogonal(d, fl, extrapolated(fl));
    if (fl->mesh->skewed) skewness_add_convection(d, fl, known);
}

void deferred_add_to_fluxes(const struct deferred *d, struct fluid *fl)
{
    if (fl->mesh->oblique) deferred_add_oblique_fluxes(fl);
    if (d->off != NULL) skewness_add_fluxes(d, fl);
}

void deferred_set_gradient(const struct deferred *d, struct fluid *fl)
{
    if (d->normal_equations == NULL) gradient_of_faces(fl);
    if (d->off == NULL) return;
    skewness_add_pressures(d, fl);
    gradient_of_faces(fl);
}

void deferred_free(struct deferred *d)
{
    if (d == NULL) return;
    free(d->reach);
    free(d->slope);
    free(d->u_boundary);
    free(d->off);
    free(d->normal_equations);
    free(d);
}

struct deferred *deferred_create(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct deferred *d;

    if (fl->options.convection->deferred == NULL && !m->oblique && !m->skewed)
        return NULL;
    d = alloc_zeroed(1, sizeof *d);
    d->reach = boundary_reach(m, fl->options.boundaries);
    d->slope = alloc_doubles(9 * m->n_cells);
    d->u_boundary = alloc_doubles(3 * (m->n_faces - m->n_internal));
    d->off = skewness_of(m);
    d->normal_equations = skewness_normal_equations(m, d->off);
    return d;
}
