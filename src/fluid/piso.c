/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/piso.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "linear/triples.h"

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

static int has_oblique_slip(const struct fluid *fl)
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

/* What the geometry says of each face, once. */
static void create_links(struct piso *ps, const struct mesh *m)
{
    ps->SS = alloc_doubles(m->n_faces);
    ps->Sd = alloc_doubles(m->n_faces);
    ps->link = alloc_doubles(m->n_faces);
    for (int f = 0; f < m->n_faces; f++) {
        const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
        ps->SS[f] = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
        ps->Sd[f] = S[0] * d[0] + S[1] * d[1] + S[2] * d[2];
        ps->link[f] = ps->SS[f] / ps->Sd[f];
    }
}

/* What particles ask for: faces where eps and drag jump. */
static void create_jumps(struct piso *ps, const struct mesh *m)
{
    ps->jump_owner = alloc_doubles(m->n_internal);
    ps->jump_neighbour = alloc_doubles(m->n_internal);
    ps->inertia = alloc_doubles(3 * m->n_cells);
    ps->bend = alloc_doubles(m->n_internal);
    ps->lean = alloc_doubles(m->n_internal);
}

/* What only some steps and schemes ask for. */
static void create_further(struct piso *ps, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    if (fl->options.coupled) create_jumps(ps, m);
    if (has(fl, BOUNDARY_SLIP)) {
        ps->slip = alloc_doubles(3 * m->n_cells);
        ps->held = alloc_doubles(3 * m->n_cells);
    }
    if (storage_is_new(&fl->options)) ps->carry_own = alloc_doubles(m->n_faces);
    if (fl->u_older != NULL) {
        ps->storage_older = alloc_doubles(m->n_cells);
        ps->u_known = alloc_doubles(3 * m->n_cells);
    }
    if (piso_rings(fl)) ps->upstream = alloc_doubles(m->n_internal);
    if (piso_rings(fl) && fl->options.pressure_shared)
        ps->rest = alloc_doubles(3 * m->n_cells);
    if (deferred_exists(fl)) {
        ps->slope = alloc_doubles(9 * m->n_cells);
        ps->u_edge = alloc_doubles(3 * (m->n_faces - m->n_internal));
    }
}

struct piso *piso_create(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const int n = m->n_cells;
    struct piso *const ps = alloc_zeroed(1, sizeof *ps);

    ps->runs = runs_create(m->n_internal, m->n_faces, m->owner, m->neighbour);
    ps->momentum =
        ldu_create(n, m->n_internal, m->owner, m->neighbour, ps->runs);
    ps->diag = alloc_doubles(n);
    ps->diag3 = alloc_doubles(3 * n);
    ps->b = alloc_doubles(3 * n);
    ps->storage = alloc_doubles(n);
    ps->past = alloc_doubles(3 * n);
    ps->rhs = alloc_doubles(3 * n);
    ps->H = alloc_doubles(3 * n);
    ps->owed = alloc_doubles(3 * n);
    ps->defect = alloc_doubles(n);
    ps->share = alloc_doubles(m->n_internal);
    ps->per_force = alloc_doubles(n);
    ps->resistance = alloc_doubles(n);
    ps->per_flux = alloc_doubles(n);
    ps->m_face = alloc_doubles(m->n_faces);
    ps->conductance = alloc_doubles(m->n_faces);
    ps->kept = alloc_doubles(m->n_faces);
    ps->phi_old = alloc_doubles(m->n_faces);
    ps->ground = alloc_doubles(n);
    ps->source = alloc_doubles(n);
    ps->divergence = alloc_doubles(n);
    create_links(ps, m);
    create_further(ps, fl);
    ps->oblique_slip = has_oblique_slip(fl);
    ps->pinned = has(fl, BOUNDARY_OUTLET) ? -1 : 0;
    ps->mg = pressure_hierarchy(m);
    ps->cg = cg_work_create(n);
    ps->bicgstab = bicgstab_work_create(n);
    return ps;
}

void piso_free(struct piso *ps)
{
    if (ps == NULL) return;
    runs_free(ps->runs);
    ldu_free(ps->momentum);
    free(ps->diag);
    free(ps->ground);
    free(ps->diag3);
    free(ps->slip);
    free(ps->held);
    free(ps->b);
    free(ps->storage);
    free(ps->past);
    free(ps->rhs);
    free(ps->H);
    free(ps->owed);
    free(ps->defect);
    free(ps->jump_owner);
    free(ps->jump_neighbour);
    free(ps->bend);
    free(ps->lean);
    free(ps->share);
    free(ps->inertia);
    free(ps->per_force);
    free(ps->resistance);
    free(ps->rest);
    free(ps->upstream);
    free(ps->per_flux);
    free(ps->SS);
    free(ps->Sd);
    free(ps->link);
    free(ps->m_face);
    free(ps->conductance);
    free(ps->kept);
    free(ps->phi_old);
    free(ps->carry_own);
    free(ps->storage_older);
    free(ps->u_known);
    free(ps->slope);
    free(ps->u_edge);
    free(ps->source);
    free(ps->divergence);
    multigrid_free(ps->mg);
    cg_work_free(ps->cg);
    bicgstab_work_free(ps->bicgstab);
    free(ps);
}

/* What subtracting u times the defect of continuity did to the sum of the
 * momentum: rho dt sum u_P defect_P. */
static void count_relabelled(struct fluid *fl)
{
    const double scale = fl->options.rho * fl->options.dt;
    double sum[3] = {0.0, 0.0, 0.0};

    triples_sum(fl->mesh->n_cells, fl->piso->defect, fl->u, sum);
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

static void note_worst(struct solve_report *worst, struct solve_report now)
{
    if (now.iterations > worst->iterations || !now.converged) *worst = now;
}

enum { MOST_CORRECTORS = 100 };

static void correct(struct fluid *fl)
{
    note_worst(&fl->report.pressure, pressure_correct(fl));
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
        gradient_update(fl); /* with the drag of now, or for the first time */
    note_worst(&fl->report.momentum, velocity_predict(fl));
    pressure_assemble(fl);
    continuity_source(fl);
    edge_inlet_fluxes(fl, fl->phi);
    for (int i = 0; i < fl->options.correctors; i++) {
        if (i == 0)
            velocity_predicted(fl);
        else
            velocity_neighbours(fl);
        correct(fl);
    }
}

/* Each corrector takes the neighbours' velocities from before. Where viscosity
 * or a long step ties cells closely, what two correctors leave is large, and
 * carried on it would grow from step to step; then they go on. A central scheme
 * puts nothing on the diagonal, and past a Courant number of 1 what it leaves
 * would grow from one to the next; a prediction with the pressure of now, in
 * which the neighbours are unknowns, takes it away. */
static void correct_further(struct fluid *fl)
{
    const double most = fl->options.splitting;
    double before = INFINITY;
    int helps = 1;

    fl->report.splitting = velocity_rest(fl);
    while (most > 0.0 && fl->report.splitting > most &&
           fl->report.correctors < MOST_CORRECTORS) {
        const int again = helps && fl->report.splitting > before;

        if (again) {
            note_worst(&fl->report.momentum, velocity_predict(fl));
            velocity_predicted(fl);
        }
        before = fl->report.splitting;
        correct(fl); /* velocity_rest left H as it is now */
        fl->report.splitting = velocity_rest(fl);
        if (again) helps = fl->report.splitting < before;
    }
}

/* One step; a repetition takes what the pass before it found. */
int fluid_step(struct fluid *fl)
{
    struct fluid_report *const report = &fl->report;
    const double *const r = fl->relabelled;
    const double relabelled[3] = {r[0], r[1], r[2]};
    double before[3];

    fluid_momentum(fl, before);
    fl->t += fl->options.dt;
    storage_begin(fl);
    report->momentum = (struct solve_report){-1, 0.0, 0.0, 1};
    report->pressure = (struct solve_report){0, 0.0, 0.0, 1};
    report->correctors = 0;
    predict_and_correct(fl);
    for (int i = 0; i < fl->options.repeats; i++) {
        storage_renew(fl);
        predict_and_correct(fl);
    }
    correct_further(fl);
    report->mass_residual = continuity_residual(fl);
    count_relabelled(fl);
    storage_end(fl);
    report->momentum_residual = balance_residual(fl, before, relabelled);
    return !(all_finite(fl) && report->pressure.converged &&
             report->momentum.converged);
}
