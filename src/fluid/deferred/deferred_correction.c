/* SPDX-License-Identifier: GPL-3.0-or-later */
/* deferred_correction.c -- deferred correction.
 *
 * These are the explicit part of a convection scheme that uses the cell
 * upstream of the upstream cell, and the non-orthogonal part of the viscous
 * stress:
 *
 *   mu grad u . S = mu (S.S / S.d) (u_N - u_P) + mu grad u . (S - d S.S / S.d)
 *
 * Both need velocity gradients, so they are computed from the velocities known
 * so far and added to the right-hand sides of the two cells with opposite
 * signs.
 */
#include "fluid/momentum_system.h"

#include <stddef.h>

#include "fluid/piso.h"
#include "fluid/deferred/skewness.h"
#include "fluid/time_levels.h"

int deferred_correction_exists(const struct fluid *fl)
{
    return fl->options.convection->deferred != NULL || fl->mesh->oblique ||
           fl->mesh->skewed;
}

static void fill_velocity_gradients(struct fluid *fl, const double *u)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++)
            boundary_face_velocity(
                fl, &fl->options.boundaries[i], f - p->first, f,
                &fl->momentum->u_boundary[3 * (f - m->n_internal)]);
    }
    fluid_velocity_gradient(fl, u, fl->momentum->u_boundary,
                            fl->momentum->velocity_gradient);
}

static double dot3(const double *slope, const double *x)
{
    return slope[0] * x[0] + slope[1] * x[1] + slope[2] * x[2];
}

/* The explicit part of the scheme for component k at face f. */
static double explicit_part(const struct fluid *fl, const double *u, int f,
                            int k)
{
    const struct mesh *const m = fl->mesh;
    const int o = m->owner[f], n = m->neighbour[f];
    const int with =
        fl->levels->convecting_flux[f] >= 0.0; /* from owner to neighbour */
    const double sign = with ? 1.0 : -1.0;
    const double step = sign * (u[3 * n + k] - u[3 * o + k]);
    const double *const slope =
        &fl->momentum->velocity_gradient[9 * (with ? o : n) + 3 * k];

    return fl->options.convection->deferred(
        step, sign * dot3(slope, &m->d[3 * f]), with ? 1.0 - m->w[f] : m->w[f]);
}

/* grad u . (S - d S.S / S.d) of component k, linear between the cells. */
static double non_orthogonal(const struct fluid *fl, const double rest[3],
                             int f, int k)
{
    const struct mesh *const m = fl->mesh;
    const double *const slope = fl->momentum->velocity_gradient;

    return m->w[f] * dot3(&slope[9 * m->owner[f] + 3 * k], rest) +
           (1.0 - m->w[f]) * dot3(&slope[9 * m->neighbour[f] + 3 * k], rest);
}

/* Adds a flux to one cell and subtracts it from the other. */
static void add_to_both_cells(struct fluid *fl, int f, int k, double force)
{
    fl->momentum->b[3 * fl->mesh->owner[f] + k] += force;
    fl->momentum->b[3 * fl->mesh->neighbour[f] + k] -= force;
}

static void add_explicit_part(struct fluid *fl, const double *u)
{
    fill_velocity_gradients(fl, u);
    for (int f = 0; f < fl->mesh->n_internal; f++)
        for (int k = 0; k < 3; k++)
            add_to_both_cells(fl, f, k,
                              -fl->options.rho *
                                  fl->levels->convecting_flux[f] *
                                  explicit_part(fl, u, f, k));
}

static void add_non_orthogonal(struct fluid *fl, const double *u)
{
    fill_velocity_gradients(fl, u);
    for (int f = 0; f < fl->mesh->n_internal; f++) {
        double rest[3];
        mesh_oblique_part(fl->mesh, f, rest);
        for (int k = 0; k < 3; k++)
            add_to_both_cells(fl, f, k,
                              fl->options.mu * non_orthogonal(fl, rest, f, k));
    }
}

/* mu sum S.S / S.d over the storage of a cell [-]: of equal cubes 6 nu dt /
 * h^2.
 */
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

void deferred_correction_add(struct fluid *fl)
{
    const double *const known =
        fl->levels->u_known != NULL ? fl->levels->u_known : fl->u;

    if (fl->options.convection->deferred != NULL) add_explicit_part(fl, known);
    if (fl->mesh->oblique || fl->mesh->skewed)
        add_non_orthogonal(fl, extrapolated(fl));
    if (fl->mesh->skewed) skewness_add_convection(fl, known);
}
