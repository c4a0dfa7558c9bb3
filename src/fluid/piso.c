/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/piso.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "linear/vec3.h"

static struct multigrid *pressure_hierarchy(const struct mesh *m)
{
    double *const strength = alloc_doubles(m->n_internal);

    for (int f = 0; f < m->n_internal; f++) {
        const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
        strength[f] = (S[0] * S[0] + S[1] * S[1] + S[2] * S[2]) /
                      (S[0] * d[0] + S[1] * d[1] + S[2] * d[2]);
    }
    struct multigrid *const mg =
        multigrid_create(m->n_cells, m->n_internal, m->owner, m->neighbour,
                         strength, m->d, m->V);
    free(strength);
    return mg;
}

static int has(const struct fluid *fl, enum boundary_kind kind)
{
    for (int i = 0; i < fl->mesh->n_patches; i++)
        if (fl->options.boundaries[i].kind == kind) return 1;
    return 0;
}

static int has_inclined_slip(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        if (fl->options.boundaries[i].kind != BOUNDARY_SLIP) continue;
        for (int f = p->first; f < p->first + p->n; f++) {
            const double *const S = &m->S[3 * f];
            const double least =
                fmin(fmin(fabs(S[0]) + fabs(S[1]), fabs(S[1]) + fabs(S[2])),
                     fabs(S[2]) + fabs(S[0]));
            if (least > 1e-12 * (fabs(S[0]) + fabs(S[1]) + fabs(S[2])))
                return 1;
        }
    }
    return 0;
}

/* Geometric coefficients of each face, computed once. */
static void create_face_coefficients(struct piso *ps, const struct mesh *m)
{
    ps->SS = alloc_doubles(m->n_faces);
    ps->Sd = alloc_doubles(m->n_faces);
    ps->face_coefficient = alloc_doubles(m->n_faces);
    for (int f = 0; f < m->n_faces; f++) {
        const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
        ps->SS[f] = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
        ps->Sd[f] = S[0] * d[0] + S[1] * d[1] + S[2] * d[2];
        ps->face_coefficient[f] = ps->SS[f] / ps->Sd[f];
    }
}

/* Arrays that are needed with particles only: jumps of eps and drag at faces.
 */
static void create_jumps(struct piso *ps, const struct mesh *m)
{
    ps->jump_owner = alloc_doubles(m->n_internal);
    ps->jump_neighbour = alloc_doubles(m->n_internal);
    ps->inertia = alloc_doubles(3 * m->n_cells);
    ps->face_pressure_offset = alloc_doubles(m->n_internal);
    ps->face_pressure_per_flux = alloc_doubles(m->n_internal);
}

/* Arrays that only some schemes need. */
static void create_optional(struct piso *ps, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    if (fl->options.coupled) create_jumps(ps, m);
    if (has(fl, BOUNDARY_SLIP)) {
        ps->slip = alloc_doubles(3 * m->n_cells);
        ps->slip_implicit = alloc_doubles(3 * m->n_cells);
    }
    if (ddt_uses_new_time(&fl->options))
        ps->convecting_flux_own = alloc_doubles(m->n_faces);
    if (fl->u_older != NULL) {
        ps->ddt_older = alloc_doubles(m->n_cells);
        ps->u_known = alloc_doubles(3 * m->n_cells);
    }
    if (piso_nondissipative(fl)) ps->upwind_bias = alloc_doubles(m->n_internal);
    if (piso_nondissipative(fl) && fl->options.pressure_shared)
        ps->smooth_force = alloc_doubles(3 * m->n_cells);
    if (deferred_correction_exists(fl)) {
        ps->velocity_gradient = alloc_doubles(9 * m->n_cells);
        ps->u_boundary = alloc_doubles(3 * (m->n_faces - m->n_internal));
    }
}

struct piso *piso_create(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int n = m->n_cells;
    struct piso *const ps = alloc_zeroed(1, sizeof *ps);

    ps->momentum =
        ldu_create(n, m->n_internal, m->owner, m->neighbour, fl->faces->pieces);
    ps->diag = alloc_doubles(n);
    ps->diag3 = alloc_doubles(3 * n);
    ps->b = alloc_doubles(3 * n);
    ps->ddt = alloc_doubles(n);
    ps->old_time_source = alloc_doubles(3 * n);
    ps->rhs = alloc_doubles(3 * n);
    ps->H = alloc_doubles(3 * n);
    ps->momentum_residual = alloc_doubles(3 * n);
    ps->defect = alloc_doubles(n);
    ps->owner_weight = alloc_doubles(m->n_internal);
    ps->per_force = alloc_doubles(n);
    ps->resistance = alloc_doubles(n);
    ps->per_flux = alloc_doubles(n);
    ps->m_face = alloc_doubles(m->n_faces);
    ps->conductance = alloc_doubles(m->n_faces);
    ps->explicit_flux = alloc_doubles(m->n_faces);
    ps->phi_old = alloc_doubles(m->n_faces);
    ps->boundary_conductance = alloc_doubles(n);
    ps->source = alloc_doubles(n);
    ps->divergence = alloc_doubles(n);
    create_face_coefficients(ps, m);
    create_optional(ps, fl);
    ps->oblique_slip = has_inclined_slip(fl);
    ps->pinned_cell = has(fl, BOUNDARY_OUTLET) ? -1 : 0;
    ps->mg = pressure_hierarchy(m);
    ps->cg = cg_work_create(n);
    ps->bicgstab = bicgstab_work_create(n);
    return ps;
}

void piso_free(struct piso *ps)
{
    if (ps == NULL) return;
    ldu_free(ps->momentum);
    free(ps->diag);
    free(ps->boundary_conductance);
    free(ps->diag3);
    free(ps->slip);
    free(ps->slip_implicit);
    free(ps->b);
    free(ps->ddt);
    free(ps->old_time_source);
    free(ps->rhs);
    free(ps->H);
    free(ps->momentum_residual);
    free(ps->defect);
    free(ps->jump_owner);
    free(ps->jump_neighbour);
    free(ps->face_pressure_offset);
    free(ps->face_pressure_per_flux);
    free(ps->owner_weight);
    free(ps->inertia);
    free(ps->per_force);
    free(ps->resistance);
    free(ps->smooth_force);
    free(ps->upwind_bias);
    free(ps->per_flux);
    free(ps->SS);
    free(ps->Sd);
    free(ps->face_coefficient);
    free(ps->m_face);
    free(ps->conductance);
    free(ps->explicit_flux);
    free(ps->phi_old);
    free(ps->convecting_flux_own);
    free(ps->ddt_older);
    free(ps->u_known);
    free(ps->velocity_gradient);
    free(ps->u_boundary);
    free(ps->source);
    free(ps->divergence);
    multigrid_free(ps->mg);
    cg_work_free(ps->cg);
    bicgstab_work_free(ps->bicgstab);
    free(ps);
}

/* Change of the total momentum by the subtracted term u times the residual of
 * continuity: rho dt sum u_P defect_P. */
static void count_relabelled(struct fluid *fl)
{
    const double scale = fl->options.rho * fl->options.dt;
    double sum[3] = {0.0, 0.0, 0.0};

    vec3_sum(fl->mesh->n_cells, fl->piso->defect, fl->u, sum);
    for (int k = 0; k < 3; k++)
        fl->relabelled[k] += scale * sum[k];
}

static int all_finite(const struct fluid *fl)
{
    double sum = 0.0; /* of zeros, or it is not finite */

    for (int c = 0; c < fl->mesh->n_cells; c++)
        sum += 0.0 *
               (fl->p[c] + fl->u[3 * c] + fl->u[3 * c + 1] + fl->u[3 * c + 2]);
    return sum == 0.0;
}

static void keep_worst_report(struct solve_report *worst,
                              struct solve_report now)
{
    if (now.iterations > worst->iterations || !now.converged) *worst = now;
}

enum { MOST_CORRECTORS = 100 };

static void correct(struct fluid *fl)
{
    keep_worst_report(&fl->report.pressure, pressure_correct(fl));
    gradient_update(fl);
    velocity_correct(fl);
    fl->report.correctors++;
}

/* PISO as [XS11 section 3.2] lists it: predict the velocity with the old
 * pressure, then correct pressure, fluxes and velocity in turn. */
static void predict_and_correct(struct fluid *fl)
{
    momentum_assemble(fl);
    gradient_begin(fl);
    if (fl->options.coupled || fl->dt_older == 0.0)
        gradient_update(fl); /* with the present drag, or in the first step */
    keep_worst_report(&fl->report.momentum, velocity_predict(fl));
    pressure_assemble(fl);
    continuity_source(fl);
    boundary_face_inlet_fluxes(fl, fl->phi);
    for (int i = 0; i < fl->options.correctors; i++) {
        if (i == 0)
            velocity_predicted_sum(fl);
        else
            velocity_neighbour_sum(fl);
        correct(fl);
    }
}

/* Each corrector uses the previous velocities of the neighbours. Where cells
 * are strongly coupled by viscosity or a long step, the residual after two
 * correctors is large, and carried into the next step it would grow; then more
 * correctors follow. A central scheme adds nothing to the diagonal, and above a
 * Courant number of 1 its residual would grow from corrector to corrector; it
 * is removed by another prediction with the present pressure, in which the
 * velocities of the neighbours are unknowns. */
static void correct_further(struct fluid *fl)
{
    const double most = fl->options.piso_tolerance;
    double before = INFINITY;
    int helps = 1;

    fl->report.piso_residual = velocity_residual(fl);
    while (most > 0.0 && fl->report.piso_residual > most &&
           fl->report.correctors < MOST_CORRECTORS) {
        const int again = helps && fl->report.piso_residual > before;

        if (again) {
            keep_worst_report(&fl->report.momentum, velocity_predict(fl));
            velocity_predicted_sum(fl);
        }
        before = fl->report.piso_residual;
        correct(fl); /* velocity_residual has set H to its present value */
        fl->report.piso_residual = velocity_residual(fl);
        if (again) helps = fl->report.piso_residual < before;
    }
}

/* One step; an outer iteration starts from the result of the previous one. */
int fluid_step(struct fluid *fl)
{
    struct fluid_report *const report = &fl->report;
    const double *const r = fl->relabelled;
    const double relabelled[3] = {r[0], r[1], r[2]};
    double before[3];

    fluid_momentum(fl, before);
    fl->t += fl->options.dt;
    ddt_begin(fl);
    report->momentum = (struct solve_report){-1, 0.0, 0.0, 1};
    report->pressure = (struct solve_report){0, 0.0, 0.0, 1};
    report->correctors = 0;
    predict_and_correct(fl);
    for (int i = 0; i < fl->options.outer_correctors; i++) {
        ddt_renew_flux(fl);
        predict_and_correct(fl);
    }
    correct_further(fl);
    report->mass_residual = continuity_residual(fl);
    count_relabelled(fl);
    ddt_end(fl);
    report->momentum_residual =
        momentum_balance_residual(fl, before, relabelled);
    return !(all_finite(fl) && report->pressure.converged &&
             report->momentum.converged);
}
