/* SPDX-License-Identifier: GPL-3.0-or-later */
/* momentum.c -- the momentum equation of the cells.
 *
 * Written conservatively, a cell gains rho (eps u)^new - rho (eps u)^old and
 * loses sum rho phi u_f. From this we subtract u_P times the mass that
 * continuity gives the cell, rho (d(eps V)/dt + sum phi):
 *
 *   rho eps_nm1 V (u_P - u_P^old) / dt + sum rho phi (u_f - u_P) = ...
 *
 * A uniform velocity then stays uniform for any eps and phi, and the diagonal
 * is minus the sum of the row. Where phi satisfies continuity the subtracted
 * term is zero; where it does not (mixture form), `defect` is its coefficient.
 */
#include "fluid/systems.h"

#include <math.h>
#include <string.h>

#include "linear/faces.h"
#include "linear/reduce.h"
#include "fluid/deferred.h"
#include "fluid/face_jump.h"
#include "fluid/piso.h"

/* Sets the two coefficients of each face, from the weights of the scheme. Where
 * nothing else needs the weights they are known for one block at a time. */
static void face_coefficients(int first, int last, struct fluid *fl)
{
    const struct fluid_options *const o = &fl->options;
    double *const all = fl->momentum->owner_weight;
    double own[PARALLEL_RANGES_BLOCK];

    for (int end; first < last; first = end) {
        const int n = last - first < PARALLEL_RANGES_BLOCK
                          ? last - first
                          : PARALLEL_RANGES_BLOCK;
        const double *restrict flux = fl->levels->convecting_flux + first;
        const double *restrict coefficient =
            fl->geometry->face_coefficient + first;
        double *restrict weight = all != NULL ? all + first : own;
        double *restrict upper = fl->momentum->matrix->upper + first;
        double *restrict lower = fl->momentum->matrix->lower + first;
        const struct convection_faces faces = {n, flux, fl->mesh->w + first,
                                               o->blend};
        end = first + n;
        o->convection->owner_weights(&faces, weight);
        if (piso_nondissipative(fl)) face_jump_bias_upwind(first, end, fl);
        for (int i = 0; i < n; i++) {
            const double flow = o->rho * flux[i]; /* [kg/s] */
            const double D = o->mu * coefficient[i];
            upper[i] = flow * (1.0 - weight[i]) - D;
            lower[i] = -flow * weight[i] - D;
        }
    }
}

/* The change during the step of the fluid fraction of the convected mass, by
 * the time scheme [-]. */
static double mass_change(const struct time_levels *l, int c)
{
    const struct time_weights *const w = &l->weights;
    const double change = w->now * l->eps_new[c] - w->old * l->eps_old[c];

    return l->eps_older != NULL ? change + w->older * l->eps_older[c] : change;
}

/* Sets the diagonal, the defect and the right-hand side of the cells, without
 * the boundary faces. */
static void cell_coefficients(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct time_levels *const levels = fl->levels;
    struct momentum_system *const momentum = fl->momentum;
    double *restrict diag = momentum->diag, *restrict defect = momentum->defect;

    ldu_row_sums(first, last, momentum->matrix, diag);
    for (int c = first; c < last; c++) {
        diag[c] = levels->ddt[c] - diag[c];
        defect[c] = mass_change(fl->levels, c) * m->V[c] / fl->options.dt;
    }
    face_loops_sum(first, last, fl->faces, face_loops_outflow,
                   levels->convecting_flux, defect);
    for (int c = first; c < last && levels->ddt_older != NULL; c++)
        diag[c] += levels->ddt_older[c];
    for (int i = 3 * first; i < 3 * last; i++)
        momentum->b[i] = momentum->residual[i];
}

/* [XS11 3.13, 3.14]: the explicit part of the drag to the right, the implicit
 * part on the diagonal. */
static void add_drag(int first, int last, struct fluid *fl)
{
    const double *restrict V = fl->mesh->V, *restrict F = fl->F;
    struct momentum_system *const momentum = fl->momentum;

    for (int c = first; c < last; c++)
        momentum->diag[c] += fl->K[c] * V[c];
    vec3_add(last - first, 1.0, V + first, F + 3L * first,
             momentum->b + 3L * first);
}

/* Adds the momentum of what enters with the velocity of its flux, phi over the
 * area times eps, and the viscous force D [kg/s] times that velocity relative
 * to the cell. */
static void add_entering_face(struct fluid *fl, int f, double D)
{
    const double *const S = mesh_S(fl->mesh, f), SS = piso_square(fl, f);
    const double phi = fl->levels->convecting_flux[f];
    const double a = D - fl->options.rho * phi;
    const int c = fl->mesh->owner[f];

    fl->momentum->diag[c] += a;
    for (int k = 0; k < 3; k++)
        fl->momentum->b[3 * c + k] += a * phi * S[k] / (fl->eps[c] * SS);
}

/* Adds the viscous force of a wall, whose velocity is tangential. */
static void add_wall_face(struct fluid *fl, const double wall[3], int f,
                          double D)
{
    const int c = fl->mesh->owner[f];

    fl->momentum->diag[c] += D;
    for (int k = 0; k < 3; k++)
        fl->momentum->b[3 * c + k] += D * wall[k];
}

static void add_boundary_face(struct fluid *fl, const struct boundary *b, int j,
                              int f)
{
    const double D = fl->options.mu * fl->geometry->face_coefficient[f];
    const double phi = fl->levels->convecting_flux[f];

    if (b->kind == BOUNDARY_NO_SLIP)
        add_wall_face(fl, boundary_wall_velocity(b, j), f, D);
    else if (b->kind == BOUNDARY_INLET)
        add_entering_face(fl, f, D);
    else if (b->enters && phi < 0.0)
        add_entering_face(fl, f, 0.0); /* without viscous force */
    else if (b->kind == BOUNDARY_OUTLET && phi < 0.0) { /* enters at rest */
        fl->momentum->diag[fl->mesh->owner[f]] -= fl->options.rho * phi;
        fl->report.backflow_faces++;
    }
}

/* At a slip wall only the normal component has a viscous force, -D n (n . u).
 * The part D n_k n_k is added to the diagonal of component k; it is the whole
 * force where the normal is parallel to an axis. */
static void add_slip_face(struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    const double *const S = mesh_S(m, f);
    const double SS = piso_square(fl, f);
    const double D = fl->options.mu * fl->geometry->face_coefficient[f];
    const int c = m->owner[f];

    for (int k = 0; k < 3; k++)
        fl->momentum->diag3[3 * c + k] += D * S[k] * S[k] / SS;
}

/* Sets the diagonals of the three components to what they have in common. */
static void spread_diagonal(int first, int last, struct momentum_system *eqn)
{
    vec3_spread(last - first, eqn->diag + first, eqn->diag3 + 3L * first);
}

static void add_slip_faces(struct fluid *fl)
{
    PARALLEL_RANGES(fl->mesh->n_cells, 4, spread_diagonal, fl->momentum);
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        if (b->kind == BOUNDARY_SLIP) add_slip_face(fl, f);
}

static void momentum_add_boundaries(struct fluid *fl)
{
    fl->report.backflow_faces = 0;
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        add_boundary_face(fl, b, j, f);
    if (fl->momentum->diag3 != NULL) add_slip_faces(fl);
}

/* [XS11 2.8] without its pressure; with eps = 1 and no particles [LS 3.13]. */
void momentum_assemble(struct fluid *fl)
{
    PARALLEL_RANGES(fl->mesh->n_internal, 4, face_coefficients, fl);
    ldu_update(fl->momentum->matrix);
    PARALLEL_BLOCKS(fl->mesh->n_cells, 12, cell_coefficients, fl);
    if (fl->options.coupled) {
        PARALLEL_RANGES(fl->mesh->n_cells, 12, add_drag, fl);
        face_jump_update(fl);
    }
    if (fl->deferred != NULL) deferred_add_to_momentum(fl->deferred, fl);
    if (fl->immersed != NULL) fl->immersed->add_friction(fl->immersed, fl);
    momentum_add_boundaries(fl);
}
