/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pressure.c -- the flux through a face, and the pressure with which the fluxes
 * satisfy continuity.
 *
 * Between P and N the fluid flows through cell P for the distance d_P and
 * through cell N for d_N. The superficial flux is the same in both, so each
 * side has its own pressure gradient, drive - phi / (m |S|), and they add up to
 * p_N - p_P:
 *
 *   phi = m_f (drive_f . S + c_f phi_old - (p_N - p_P) S.S / S.d)
 *   1 / m_f = (1 - w) / m_P + w / m_N,   drive_f, c_f averaged alike
 *
 * The drag, which jumps with eps, is thus interpolated to a face as the
 * pressure gradient is, and a packed column has its exact pressure drop. (Where
 * eps jumps, the fluid's inertia causes a jump of p_N - p_P: face_jump.c.) The
 * term with phi_old is the time derivative at the face itself: in a steady flow
 * it cancels, and the solution does not depend on the time step.
 */
#include "fluid/systems.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "linear/faces.h"
#include "linear/reduce.h"
#include "fluid/deferred.h"
#include "fluid/face_jump.h"
#include "fluid/piso.h"

/* Sets the coefficients of the cells that their faces use, once a step: the
 * time derivative per superficial flux, which is rho eps_old / (gamma dt
 * eps_phi) with implicit Euler; 1 / (gamma V), for the forces; and 1 / m_P. */
static void cell_resistances(int first, int last, const struct fluid *fl)
{
    const struct pressure_system *const pressure = fl->pressure;
    const double *restrict V = fl->mesh->V, *restrict eps = fl->eps;
    const double *restrict diag = fl->momentum->diag;
    const double *restrict ddt = fl->levels->ddt, *restrict eps_phi = fl->eps_n;
    double *restrict per_flux = pressure->per_flux, *restrict per_force =
                                                        pressure->per_force;
    double *restrict resistance = pressure->resistance;

    for (int c = first; c < last; c++) {
        per_force[c] = 1.0 / (piso_gamma(fl, c) * V[c]);
        per_flux[c] = ddt[c] * per_force[c] / eps_phi[c];
        resistance[c] = diag[c] * per_force[c] / eps[c];
    }
}

/* The same for the flux one step earlier, in a two-step scheme. */
double pressure_older_per_flux(const struct fluid *fl, int c)
{
    return fl->levels->ddt_older[c] * fl->pressure->per_force[c] /
           fl->eps_nm1[c];
}

/* Adds the contribution of the flux one step before the last, in a two-step
 * scheme. */
static void store_old_time_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct pressure_system *const pressure = fl->pressure;

    for (int f = 0; f < m->n_internal; f++)
        pressure->explicit_flux[f] +=
            pressure->m_face[f] * fl->phi_older[f] *
            ((1.0 - m->w[f]) * pressure_older_per_flux(fl, m->owner[f]) +
             m->w[f] * pressure_older_per_flux(fl, m->neighbour[f]));
    /* m_face: outlets only */
    for (int f = m->n_internal; f < fl->faces->n; f++)
        pressure->explicit_flux[f] += pressure->m_face[f] * fl->phi_older[f] *
                                      pressure_older_per_flux(fl, m->owner[f]);
}

/* Sets m_f, and the terms that are the same for all correctors: the conductance
 * and the part of the flux by the time derivative. */
FACE_KERNEL inner_mobility(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct pressure_system *const pressure = fl->pressure;
    const double *const r = pressure->resistance;
    const double *const per_flux = pressure->per_flux;
    const double w = fl->mesh->w[f];
    const double m = 1.0 / ((1.0 - w) * r[o] + w * r[n]);

    pressure->m_face[f] = m;
    pressure->conductance[f] = m * fl->geometry->face_coefficient[f];
    pressure->explicit_flux[f] = m *
                                 ((1.0 - w) * per_flux[o] + w * per_flux[n]) *
                                 fl->levels->phi_old[f];
}

/* The inertia at jumps of eps acts as a jump of the pressure and not as a
 * gradient: it is subtracted from H, the forces of the cells. */
FACE_KERNEL inner_jump(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const struct face_jump *const jump = fl->jump;
    const struct pressure_system *const pressure = fl->pressure;
    const double w = fl->mesh->w[f], *const S = mesh_S(fl->mesh, f);
    const double slope =
        (1.0 - w) * pressure->per_force[o] *
            vector_dot(&jump->inertia[3 * o], S) +
        w * pressure->per_force[n] * vector_dot(&jump->inertia[3 * n], S);

    pressure->explicit_flux[f] +=
        pressure->conductance[f] * jump->pressure_jump[f] -
        pressure->m_face[f] * slope;
}

static void store_jump_fluxes(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct pressure_system *const pressure = fl->pressure;

    FOR_EACH_FACE(fl->faces, 8, inner_jump, fl);
    for (int f = m->n_internal; f < fl->faces->n; f++) { /* m_face: outlets */
        const int o = m->owner[f];
        pressure->explicit_flux[f] -=
            pressure->m_face[f] * pressure->per_force[o] *
            vector_dot(&fl->jump->inertia[3 * o], mesh_S(m, f));
    }
}

/* Finds the mobility of each face (6.6), and what its old flux contributes. */
static void face_mobilities(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct time_levels *const levels = fl->levels;
    struct pressure_system *const pressure = fl->pressure;

    PARALLEL_RANGES(m->n_cells, 12, cell_resistances, fl);
    FOR_EACH_FACE(fl->faces, 4, inner_mobility, fl);
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        const int o = m->owner[f];
        pressure->m_face[f] =
            b->kind == BOUNDARY_OUTLET ? 1.0 / pressure->resistance[o] : 0.0;
        pressure->conductance[f] =
            pressure->m_face[f] * fl->geometry->face_coefficient[f];
        pressure->explicit_flux[f] =
            pressure->m_face[f] * pressure->per_flux[o] * levels->phi_old[f];
    }
    if (levels->ddt_older != NULL) store_old_time_fluxes(fl);
    if (fl->options.coupled) store_jump_fluxes(fl);
    if (fl->immersed != NULL) fl->immersed->change_faces(fl->immersed, fl);
}

/* Without an outlet the pressure is fixed to zero in one cell, with a
 * coefficient as large as the sum of those to its neighbours. */
static double pin_pressure(const struct fluid *fl, int c)
{
    const struct mesh *const m = fl->mesh;
    double sum = 0.0;

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
        if (m->cell_face[a] < fl->faces->n)
            sum += fl->pressure->conductance[m->cell_face[a]];
    return sum > 0.0 ? sum : 1.0; /* a single cell */
}

void pressure_assemble(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct pressure_system *const pressure = fl->pressure;

    face_mobilities(fl);
    memset(pressure->boundary_conductance, 0,
           (size_t)m->n_cells * sizeof *pressure->boundary_conductance);
    for (int f = m->n_internal; f < fl->faces->n; f++)
        pressure->boundary_conductance[m->owner[f]] += pressure->conductance[f];
    if (pressure->pinned_cell >= 0)
        pressure->boundary_conductance[pressure->pinned_cell] +=
            pin_pressure(fl, pressure->pinned_cell);
    if (fl->options.shared == NULL)
        preconditioned_set(pressure->matrix, pressure->conductance,
                           pressure->boundary_conductance);
}

/* The flux without the pressure, from H . S of the cells beside the face. */
FACE_SUM_KERNEL flux_of(const struct fluid *fl, int f, int o, int n, double H_o,
                        double H_n)
{
    const struct pressure_system *const pressure = fl->pressure;
    const double w = fl->mesh->w[f];
    const double from_o = (1.0 - w) * pressure->per_force[o];
    const double from_n = w * pressure->per_force[n];

    return pressure->explicit_flux[f] +
           pressure->m_face[f] * (from_o * H_o + from_n * H_n);
}

FACE_KERNEL pressure_inner_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;
    const double *const H = fl->momentum->H, *const S = mesh_S(fl->mesh, f);

    fl->phi[f] = flux_of(fl, f, o, n, vector_dot(&H[3 * o], S),
                         vector_dot(&H[3 * n], S));
}

/* The same where each face is normal to an axis, so that the other components
 * of H add nothing. */
static void aligned_fluxes(int first, int last, const struct fluid *fl)
{
    const double *const area = fl->faces->area;
    struct face_piece p = {0};

    while (faces_next(fl->faces, first, last, &p)) {
        const double *const H = fl->momentum->H + p.axis;
        const int f = p.face, o = p.cell, n = p.other, m = p.n;

#pragma omp simd
        for (int j = 0; j < m; j++)
            fl->phi[f + j] =
                flux_of(fl, f + j, o + j, n + j, H[3 * (o + j)] * area[f + j],
                        H[3 * (n + j)] * area[f + j]);
    }
}

/* Sets phi without the part of the pressure. The fluxes of walls and inlets are
 * given. */
static void predicted_fluxes(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct pressure_system *const pressure = fl->pressure;

    if (faces_aligned(fl->faces))
        PARALLEL_BLOCKS(m->n_cells, 8, aligned_fluxes, fl);
    else
        FOR_EACH_FACE(fl->faces, 8, pressure_inner_flux, fl);
    if (fl->jump->smooth_force != NULL) face_jump_add_gamma_fluxes(fl);
    if (fl->deferred != NULL) deferred_add_to_fluxes(fl->deferred, fl);
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f) {
        const int o = m->owner[f];
        if (b->kind == BOUNDARY_OUTLET)
            fl->phi[f] = pressure->explicit_flux[f] +
                         pressure->m_face[f] * pressure->per_force[o] *
                             vector_dot(&fl->momentum->H[3 * o], mesh_S(m, f));
    }
}

FACE_SUM_KERNEL inflow(int f, double out, const void *phi)
{
    return -face_loops_outflow(f, out, phi);
}

/* Sets the residual of continuity of these fluxes, the right-hand side. */
static void rhs_rows(int first, int last, const struct fluid *fl)
{
    const struct pressure_system *const pressure = fl->pressure;

    for (int c = first; c < last; c++)
        pressure->divergence[c] = -pressure_source(pressure, c);
    face_loops_sum(first, last, fl->faces, inflow, fl->phi,
                   pressure->divergence);
}

FACE_SUM_KERNEL mean_size(int f, double out, const void *with)
{
    const struct fluid *const fl = with;

    (void)out;
    return 0.5 * (fabs(fl->phi[f]) + fabs(fl->levels->phi_old[f]));
}

/* Returns the sum of squares of the sums of |phi| over the faces of each cell
 * [(m^3/s)^2]; the array of the divergence serves as work space. */
static double scale_rows(int first, int last, const struct fluid *fl)
{
    const struct pressure_system *const pressure = fl->pressure;

    for (int c = first; c < last; c++)
        pressure->divergence[c] = fabs(pressure_source(pressure, c));
    face_loops_sum(first, last, fl->faces, mean_size, fl, pressure->divergence);
    return reduce_range(first, last, pressure->divergence,
                        pressure->divergence);
}

/* Both, for a block of cells at a time. */
static double scale_and_rhs_rows(int first, int last, const struct fluid *fl)
{
    double squares = 0.0;

    for (int end; first < last; first = end) {
        end = last - first < PARALLEL_RANGES_BLOCK
                  ? last
                  : first + PARALLEL_RANGES_BLOCK;
        squares += scale_rows(first, end, fl);
        rhs_rows(first, end, fl);
    }
    return squares;
}

/* Sets the right-hand side of the pressure equation; and in the first corrector
 * of a step the scale of its residual, which is the 2-norm of the sums of |phi|
 * of the cells. If this is zero, because a force is added only later, it is set
 * in the first corrector in which there are fluxes. */
static void pressure_rhs(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct pressure_system *const pressure = fl->pressure;

    if (fl->report.correctors == 0 || pressure->scale == 0.0) {
        double squares;

        PARALLEL_SUM(squares, m->n_cells, 8, scale_and_rhs_rows, fl);
        pressure->scale = sqrt(squares);
    } else
        PARALLEL_BLOCKS(m->n_cells, 8, rhs_rows, fl);
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        if (b->kind == BOUNDARY_OUTLET)
            pressure->divergence[m->owner[f]] +=
                pressure->conductance[f] * b->pressure;
}

FACE_KERNEL inner_pressure_flux(int f, int o, int n, const void *with)
{
    const struct fluid *const fl = with;

    fl->phi[f] -= fl->pressure->conductance[f] * (fl->p[n] - fl->p[o]);
}

/* Adds to each flux [m^3/s] the part that the pressures beside the face
 * drive. */
static void add_pressure_fluxes(struct fluid *fl)
{
    const struct pressure_system *const pressure = fl->pressure;

    FOR_EACH_FACE(fl->faces, 4, inner_pressure_flux, fl);
    FOR_EACH_BOUNDARY_FACE (fl, b, j, f)
        if (b->kind == BOUNDARY_OUTLET)
            fl->phi[f] -= pressure->conductance[f] *
                          (b->pressure - fl->p[fl->mesh->owner[f]]);
}

struct solve_report pressure_correct(struct fluid *fl)
{
    struct pressure_system *const pressure = fl->pressure;

    predicted_fluxes(fl);
    if (gradient_mean_exists(&fl->options)) gradient_add_mean(fl);
    pressure_rhs(fl);
    const int last = fl->report.correctors >= fl->options.correctors - 1;
    const double relative = last ? 0.0 : fl->options.p_relative_tolerance;
    const double absolute = fl->options.tolerance * pressure->scale;
    const struct shared_solution *const shared = fl->options.shared;
    const struct solve_report report =
        shared != NULL ? shared->pressure(shared->parts, fl, relative, absolute)
                       : cg_solve(pressure->matrix, pressure->divergence, fl->p,
                                  relative, absolute, 500, pressure->cg);
    if (last || !piso_alone(fl)) add_pressure_fluxes(fl);
    return report;
}
