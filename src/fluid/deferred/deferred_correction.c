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
 *   - what is computed below where the line between two centres misses that
 *     of their face.
 *
 * The first two need velocity gradients, so they are computed from the
 * velocities known so far and added to the right-hand sides of the two cells
 * with opposite signs.
 */
#include "fluid/deferred.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "fluid/fluid.h"
#include "fluid/systems.h"
#include "fluid/piso.h"
#include "linear/faces.h"

/* --- faces whose middle the link of their cells misses
 *
 * The value linear between two cells is that where their link crosses the face.
 * On tetrahedra the middle of the face is off that point, by a vector off, and
 * what a sum over faces needs is the value there:
 *
 *   x_f = w x_P + (1 - w) x_N + off . grad x
 *
 * Without the second term the gradient of a linear field is wrong on the finest
 * mesh, too. The terms are taken from the gradients known so far; that of the
 * pressure, on meshes with tetrahedra, from least squares, which are exact for
 * a linear pressure.
 */

static const double largest_off = 0.8; /* [-] of the link */

/* 1 where the link is at more than 63 degrees to the normal of an inner face,
 * as between flat tetrahedra. There the terms of this file would amplify
 * themselves from corrector to corrector, and are left out: the values of such
 * faces are of first order. */
static int too_oblique(const struct mesh *m, int f)
{
    const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
    const double along = vector_dot(S, d);
    const double min = 0.2; /* [-] squared cosine */

    return f < m->n_internal &&
           along * along < min * vector_dot(S, S) * vector_dot(d, d);
}

/* off of each face [m], 3 each, of a boundary face the part of the link along
 * the face; NULL, which the functions below are not called with, for a mesh
 * without. It is at most 0.8 of the link, and 0 where that is at more than 63
 * degrees to the normal: in flat cells the terms would otherwise amplify
 * themselves. */
static double *skewness_of(const struct mesh *m)
{
    if (!m->skewed) return NULL;
    double *const off = alloc_doubles(3 * m->n_faces);

    for (int f = 0; f < m->n_faces; f++) {
        double *const to = &off[3 * f];
        mesh_off_middle(m, f, to);
        const double max =
            too_oblique(m, f) ? 0.0 : largest_off * vector_length(mesh_d(m, f));
        const double factor = fmin(1.0, max / vector_length(to));
        for (int k = 0; k < 3 && factor < 1.0; k++)
            to[k] *= factor;
    }
    return off;
}

/* d = the link of cell c across face f; at the boundary, the part of it that is
 * normal to the face [m]. */
static void link_of(const struct mesh *m, const double *off, int c, int f,
                    double d[3])
{
    const double sign = m->owner[f] == c ? 1.0 : -1.0;

    for (int k = 0; k < 3; k++)
        d[k] =
            sign * mesh_d(m, f)[k] - (f < m->n_internal ? 0.0 : off[3 * f + k]);
}

/* The sums of d d / |d|^4 over the links of each cell [1/m^2], 6 each
 * (vector.h), of a boundary face with the part of the link normal to it; NULL
 * for a mesh without tetrahedra. */
static double *skewness_normal_equations(const struct mesh *m,
                                         const double *off)
{
    if (m->skewed != 2) return NULL;
    double *const matrix = alloc_doubles(6 * m->n_cells);

    for (int c = 0; c < m->n_cells; c++)
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            double d[3];
            link_of(m, off, c, m->cell_face[a], d);
            const double square = vector_dot(d, d);
            for (int i = 0, n = 0; i < 3; i++)
                for (int j = i; j < 3; j++, n++)
                    matrix[6 * c + n] += d[i] * d[j] / (square * square);
        }
    return matrix;
}

/* Sets the gradient of p by least squares, with the present pressures of the
 * boundary faces. */
static void pressure_slopes(int first, int last, const struct deferred *d,
                            struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int c = first; c < last; c++) {
        double right[3] = {0.0, 0.0, 0.0}, link[3];
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            const double beyond = f >= m->n_internal ? fl->p_face[f]
                                  : m->owner[f] == c ? fl->p[m->neighbour[f]]
                                                     : fl->p[m->owner[f]];
            link_of(m, d->off, c, f, link);
            const double square = vector_dot(link, link);
            vector_along(right, (beyond - fl->p[c]) / (square * square), link,
                         right);
        }
        vector_solve(&d->normal_equations[6 * c], right, &fl->grad_p[3 * c]);
        vector_along(&fl->grad_p[3 * c], 1.0, fl->mean_gradient,
                     &fl->grad_p[3 * c]);
    }
}

/* off . grad x of an inner face, linear between the cells; `per` is how many
 * numbers `slope` has for each cell. */
static inline double skew_term(const struct deferred *d, const struct mesh *m,
                               const double *slope, int per, int f, int o,
                               int n)
{
    const double w = m->w[f], *const off = &d->off[3 * f];

    return w * vector_dot(&slope[per * o], off) +
           (1.0 - w) * vector_dot(&slope[per * n], off);
}

FACE_KERNEL inner_pressure(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct deferred *const d = fl->deferred;
    fl->p_face[f] += skew_term(d, fl->mesh, fl->grad_p, 3, f, o, n) -
                     vector_dot(fl->mean_gradient, &d->off[3 * f]);
}

/* Adds the term to p_face, from the gradients of the linear values. */
static void skewness_add_pressures(const struct deferred *d, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    if (d->normal_equations != NULL)
        PARALLEL_RANGES(m->n_cells, 30, pressure_slopes, d, fl);
    FOR_EACH_FACE(fl->faces, 12, inner_pressure, fl);
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        const double *const off = &d->off[3 * f];
        if (b->kind == BOUNDARY_OUTLET) continue;
        fl->p_face[f] += vector_dot(&fl->grad_p[3 * m->owner[f]], off) -
                         vector_dot(fl->mean_gradient, off);
    }
}

/* Adds the term to the flux. The time derivative at the face contains the old
 * flux as it is, so that only the part 1 - m_f c_f of the term is added, by the
 * other forces; in a steady flow that makes all of it, for any step. */
FACE_KERNEL skewness_inner_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct deferred *const d = fl->deferred;
    const struct pressure_system *const pressure = fl->pressure;
    const double *const slope = d->slope;
    const double w = fl->mesh->w[f], *const S = mesh_S(fl->mesh, f);
    const double eps = w * fl->eps[o] + (1.0 - w) * fl->eps[n];
    double per_flux =
        (1.0 - w) * pressure->per_flux[o] + w * pressure->per_flux[n];
    double flux = 0.0;

    if (fl->levels->ddt_older != NULL)
        per_flux += (1.0 - w) * pressure_older_per_flux(fl, o) +
                    w * pressure_older_per_flux(fl, n);
    for (int k = 0; k < 3; k++)
        flux += S[k] * skew_term(d, fl->mesh, slope + 3 * k, 9, f, o, n);
    fl->phi[f] += (1.0 - pressure->m_face[f] * per_flux) * eps * flux;
}

/* The part of the resistance of a cell that viscosity and convection cause,
 * without the drag and the time derivative. */
static double resistance_of_neighbours(const struct fluid *fl, int c)
{
    double local = fl->levels->ddt[c];

    if (fl->levels->ddt_older != NULL) local += fl->levels->ddt_older[c];
    if (fl->options.coupled) local += fl->K[c] * fl->mesh->V[c];
    return (fl->momentum->diag[c] - local) * fl->pressure->per_force[c] /
           fl->eps[c];
}

/* The flux is a mean of the two velocities, weighted with (1 - w) / m_P and w /
 * m_N. That is right for drag and inertia, which are forces of one cell. For
 * those of the neighbours it replaces this mean by the linear one less the
 * height of a parabola's chord, w (1 - w) (grad u_N - grad u_P) . d / 2. */
FACE_KERNEL inner_mean(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct deferred *const d = fl->deferred;
    const double *const slope = d->slope;
    const double *const link = mesh_d(fl->mesh, f), *const S =
                                                        mesh_S(fl->mesh, f);
    const double w = fl->mesh->w[f];
    const double r_o = (1.0 - w) * resistance_of_neighbours(fl, o);
    const double r_n = w * resistance_of_neighbours(fl, n);
    const double eps = w * fl->eps[o] + (1.0 - w) * fl->eps[n];
    double difference = 0.0, chord = 0.0;

    for (int k = 0; k < 3; k++) {
        const double bend = vector_dot(&slope[9 * n + 3 * k], link) -
                            vector_dot(&slope[9 * o + 3 * k], link);
        chord += S[k] * 0.5 * w * (1.0 - w) * bend;
        difference += S[k] * (fl->eps[n] * fl->u[3 * n + k] -
                              fl->eps[o] * fl->u[3 * o + k]);
    }
    fl->phi[f] +=
        fl->pressure->m_face[f] *
        (((1.0 - w) * r_o - w * r_n) * difference - (r_o + r_n) * eps * chord);
}

/* Adds it to the fluxes without the pressure; to the convection of the momentum
 * equation, as far as the scheme is of second order. */
static void skewness_add_fluxes(const struct deferred *d, struct fluid *fl)
{
    FOR_EACH_FACE(fl->faces, 24, skewness_inner_flux, fl);
    if (d->normal_equations != NULL)
        FOR_EACH_FACE(fl->faces, 32, inner_mean, fl);
}

/* The fraction of linear interpolation in the weights of a scheme of two cells
 * [-]. */
static double linear_fraction(const struct fluid *fl, int f, double upwind)
{
    const double w = fl->mesh->w[f];

    return (upwind - fl->momentum->owner_weight[f]) / (upwind - w);
}

/* The term of component k for a scheme with the gradient of the upstream cell;
 * it is limited by the same factor as the slope along the link. */
static double skew_term_upstream(const struct deferred *d,
                                 const struct fluid *fl, const double *u, int f,
                                 int with, int k)
{
    const struct mesh *const m = fl->mesh;
    const int o = m->owner[f], n = m->neighbour[f];
    const double sign = with ? 1.0 : -1.0;
    const double *const slope = &d->slope[9 * (with ? o : n) + 3 * k];
    const double reach = with ? 1.0 - m->w[f] : m->w[f];
    const double rise = sign * vector_dot(slope, mesh_d(m, f));
    const double taken = fl->options.convection->deferred(
        sign * (u[3 * n + k] - u[3 * o + k]), rise, reach);
    const double limiter = rise != 0.0 ? taken / (reach * rise) : 0.0;

    return fmax(0.0, fmin(limiter, 1.0)) * vector_dot(slope, &d->off[3 * f]);
}

static void skewness_add_convection(const struct deferred *d, struct fluid *fl,
                                    const double *u)
{
    const struct mesh *const m = fl->mesh;
    const double *const slope = d->slope;
    double *const b = fl->momentum->b;

    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double phi = fl->levels->convecting_flux[f];
        const int with = phi >= 0.0; /* from owner to neighbour */
        for (int k = 0; k < 3; k++) {
            const double term =
                fl->options.convection->deferred != NULL
                    ? skew_term_upstream(d, fl, u, f, with, k)
                    : linear_fraction(fl, f, with) *
                          skew_term(d, fl->mesh, slope + 3 * k, 9, f, o, n);
            const double force = -fl->options.rho * phi * term; /* [N] */
            b[3 * o + k] += force;
            b[3 * n + k] -= force;
        }
    }
}

/* --- all terms --- */

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
        step, sign * vector_dot(slope, mesh_d(m, f)),
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
    double *const to = fl->momentum->H; /* work space that is not in use here */
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

struct deferred *deferred_create(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct deferred *d;

    if (fl->options.convection->deferred == NULL && !m->oblique && !m->skewed)
        return NULL;
    d = owner_create(sizeof *d);
    d->reach = owner_take(d, boundary_reach(m, fl->options.boundaries));
    d->slope = owner_doubles(d, 9 * m->n_cells);
    d->u_boundary = owner_doubles(d, 3 * (m->n_faces - m->n_internal));
    d->off = owner_take(d, skewness_of(m));
    d->normal_equations = owner_take(d, skewness_normal_equations(m, d->off));
    return d;
}
