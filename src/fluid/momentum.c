/* SPDX-License-Identifier: GPL-3.0-or-later */
/* momentum.c -- the momentum equation of the cells.
 *
 * Written conservatively, a cell gains rho (eps u)^new - rho (eps u)^old and
 * loses sum rho phi u_f. From this we subtract u_P times the mass that
 * continuity gives the cell, rho (d(eps V)/dt + sum phi):
 *
 *   rho eps_start V (u_P - u_P^old) / dt + sum rho phi (u_f - u_P) = ...
 *
 * A uniform velocity then stays uniform whatever eps and phi do, and the
 * diagonal is minus the sum of the row. Where phi meets continuity nothing was
 * subtracted; where it does not (mixture form), `defect` says how much.
 */
#include "fluid/piso.h"

#include <math.h>
#include <string.h>

/* The part of cell c in the flux through one of its faces, outward. */
static double outward(const struct mesh *m, const double *phi, int c, int f)
{
    return m->owner[f] == c ? phi[f] : -phi[f];
}

/* S.S / (S.d): area over length of the link [m]. */
static double link_strength(const struct mesh *m, int f)
{
    const double *const S = &m->S[3 * f], *const d = &m->d[3 * f];
    return (S[0] * S[0] + S[1] * S[1] + S[2] * S[2]) /
           (S[0] * d[0] + S[1] * d[1] + S[2] * d[2]);
}

static void link_coefficients(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct fluid_options *const o = &fl->options;
    struct csr *const A = fl->piso->momentum;

    const struct convection_faces faces = {m->n_internal, fl->piso->carry, m->w,
                                           o->blend};

    o->convection->shares(&faces, fl->piso->share);
    for (int f = 0; f < m->n_internal; f++) {
        const double flow = o->rho * fl->piso->carry[f]; /* [kg/s] */
        const double share = fl->piso->share[f];
        const double D = o->mu * link_strength(m, f);
        A->a[A->upper[f]] = flow * (1.0 - share) - D;
        A->a[A->lower[f]] = -flow * share - D;
    }
}

/* By how much the fluid fraction of the mass that u has grows in the step. */
static double mass_change(const struct piso *ps, int c)
{
    const struct time_weights *const w = &ps->weights;
    const double change = w->now * ps->eps_new[c] - w->old * ps->eps_old[c];

    return ps->eps_older != NULL ? change + w->older * ps->eps_older[c]
                                 : change;
}

/* Diagonal and right side of all cells, boundaries aside. */
static void cell_coefficients(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    const struct fluid_options *const o = &fl->options;
    struct piso *const ps = fl->piso;
    struct csr *const A = ps->momentum;

    for (int c = 0; c < m->n_cells; c++) {
        double sum = 0.0, out = 0.0;
        for (int e = A->start[c]; e < A->start[c + 1]; e++)
            sum += A->a[e];
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
            out += outward(m, ps->carry, c, m->cell_face[a]);
        ps->defect[c] = mass_change(ps, c) * m->V[c] / o->dt + out;
        A->diag[c] = ps->storage[c] - sum;
        if (ps->storage_older != NULL) A->diag[c] += ps->storage_older[c];
        for (int k = 0; k < 3; k++)
            ps->b[3 * c + k] = ps->owed[3 * c + k];
    }
}

/* [XS11 3.13, 3.14]: the explicit part of the drag to the right, the implicit
 * part on the diagonal. */
static void add_drag(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    for (int c = 0; c < m->n_cells; c++) {
        ps->momentum->diag[c] += fl->K[c] * m->V[c];
        for (int k = 0; k < 3; k++)
            ps->b[3 * c + k] += fl->F[3 * c + k] * m->V[c];
    }
}

/* Fluid enters with the velocity that carries phi through the fluid's share
 * of the face. */
static void add_inlet_face(struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    const double *const S = &m->S[3 * f], phi = fl->piso->carry[f];
    const int c = m->owner[f];
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
    const double a =
        fl->options.mu * link_strength(m, f) - fl->options.rho * phi;

    fl->piso->momentum->diag[c] += a;
    for (int k = 0; k < 3; k++)
        fl->piso->b[3 * c + k] += a * phi * S[k] / (fl->eps[c] * SS);
}

/* A wall, which may move along itself. */
static void add_wall_face(struct fluid *fl, const double wall[3], int f)
{
    const int c = fl->mesh->owner[f];
    const double D = fl->options.mu * link_strength(fl->mesh, f);

    fl->piso->momentum->diag[c] += D;
    for (int k = 0; k < 3; k++)
        fl->piso->b[3 * c + k] += D * wall[k];
}

static void add_boundary_face(struct fluid *fl, const struct boundary *b, int f)
{
    const int c = fl->mesh->owner[f];
    const double phi = fl->piso->carry[f];

    if (b->kind == BOUNDARY_NO_SLIP)
        add_wall_face(fl, b->wall, f);
    else if (b->kind == BOUNDARY_INLET)
        add_inlet_face(fl, f);
    else if (b->kind == BOUNDARY_OUTLET && phi < 0.0) { /* enters at rest */
        fl->piso->momentum->diag[c] -= fl->options.rho * phi;
        fl->report.backflow_faces++;
    }
}

/* A slip wall holds back the normal component only, by -D n (n . u): n_k n_k on
 * the diagonal of the components, which is all of it where normal and axes are
 * parallel. */
static void add_slip_face(struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    const double *const S = &m->S[3 * f];
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
    const double D = fl->options.mu * link_strength(m, f);

    const int c = m->owner[f];

    for (int k = 0; k < 3; k++)
        fl->piso->diag3[3 * c + k] += D * S[k] * S[k] / SS;
}

/* The rest of it, -D n_k (n . u - n_k u_k) for an oblique wall, goes to the
 * right with the velocity of now. */
static void add_slip_rest(const struct fluid *fl, double *right)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        if (fl->options.boundaries[i].kind != BOUNDARY_SLIP) continue;
        for (int f = p->first; f < p->first + p->n; f++) {
            const double *const S = &m->S[3 * f];
            const double *const u = &fl->u[3 * m->owner[f]];
            const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
            const double Su = S[0] * u[0] + S[1] * u[1] + S[2] * u[2];
            const double D = fl->options.mu * link_strength(m, f);
            for (int k = 0; k < 3; k++)
                right[3 * m->owner[f] + k] -=
                    D * S[k] * (Su - S[k] * u[k]) / SS;
        }
    }
}

static void add_boundaries(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    fl->report.backflow_faces = 0;
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        for (int f = p->first; f < p->first + p->n; f++)
            add_boundary_face(fl, &fl->options.boundaries[i], f);
    }
    for (int c = 0; c < m->n_cells; c++)
        for (int k = 0; k < 3; k++)
            ps->diag3[3 * c + k] = ps->momentum->diag[c];
    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        if (fl->options.boundaries[i].kind != BOUNDARY_SLIP) continue;
        for (int f = p->first; f < p->first + p->n; f++)
            add_slip_face(fl, f);
    }
}

/* [XS11 2.8] without its pressure; with eps = 1 and no particles [LS 3.13]. */
void momentum_assemble(struct fluid *fl)
{
    link_coefficients(fl);
    cell_coefficients(fl);
    if (fl->options.coupled) {
        add_drag(fl);
        jump_update(fl);
    }
    if (fl->piso->slope != NULL) deferred_add(fl);
    add_boundaries(fl);
}

/* The terms that stay on the right for a given pressure [N]. */
static double known(const struct fluid *fl, int c, int k)
{
    const struct piso *const ps = fl->piso;
    const int i = 3 * c + k;
    return ps->past[i] - piso_gamma(fl, c) * fl->mesh->V[c] * fl->grad_p[i];
}

struct solve_report momentum_predict(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    for (int c = 0; c < fl->mesh->n_cells; c++)
        for (int k = 0; k < 3; k++)
            ps->rhs[3 * c + k] = ps->b[3 * c + k] + known(fl, c, k);
    if (ps->oblique_slip) add_slip_rest(fl, ps->rhs);
    return bicgstab_solve(ps->momentum, ps->diag3, ps->rhs, fl->u,
                          fl->options.tolerance, 1e-300, 200, ps->bicgstab);
}

void momentum_neighbours(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    csr_multiply_each(ps->momentum, 3, NULL, fl->u, ps->H);
    for (int c = 0; c < fl->mesh->n_cells; c++)
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            const double slip = ps->diag3[i] - ps->momentum->diag[c];
            ps->H[i] = ps->b[i] - ps->H[i] - slip * fl->u[i];
        }
    if (ps->oblique_slip) add_slip_rest(fl, ps->H);
}

/* H has the slip walls' part with the velocity from before. Where viscosity
 * crosses the cell within a step that would overshoot from one corrector to the
 * next, and the new velocity is taken. */
void momentum_correct(struct fluid *fl)
{
    const struct piso *const ps = fl->piso;

    for (int c = 0; c < fl->mesh->n_cells; c++)
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            const double slip = ps->diag3[i] - ps->momentum->diag[c];
            const double right = ps->H[i] + known(fl, c, k);
            fl->u[i] = slip > 0.25 * ps->storage[c]
                           ? (right + slip * fl->u[i]) / ps->diag3[i]
                           : right / ps->momentum->diag[c];
        }
}

double momentum_rest(struct fluid *fl)
{
    struct piso *const ps = fl->piso;
    double worst = 0.0, largest = 0.0;

    momentum_neighbours(fl);
    for (int c = 0; c < fl->mesh->n_cells; c++)
        for (int k = 0; k < 3; k++) {
            const int i = 3 * c + k;
            const double own = ps->momentum->diag[c] * fl->u[i];
            ps->owed[i] = ps->H[i] + known(fl, c, k) - own;
            worst = fmax(worst, fabs(ps->owed[i]));
            largest = fmax(largest, fabs(own));
        }
    return largest > 0.0 ? worst / largest : 0.0;
}
