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

#include "linear/triples.h"

/* The two coefficients of each face. */
static void link_coefficients(int first, int last, struct fluid *fl)
{
    const struct fluid_options *const o = &fl->options;
    const double *restrict carry = fl->piso->carry;
    const double *restrict link = fl->piso->link;
    double *restrict share = fl->piso->share;
    double *restrict upper = fl->piso->momentum->upper;
    double *restrict lower = fl->piso->momentum->lower;
    const struct convection_faces faces = {last - first, carry + first,
                                           fl->mesh->w + first, o->blend};

    o->convection->shares(&faces, share + first);
    if (piso_rings(fl)) jump_lean(first, last, fl);
    for (int f = first; f < last; f++) {
        const double flow = o->rho * carry[f]; /* [kg/s] */
        const double D = o->mu * link[f];
        upper[f] = flow * (1.0 - share[f]) - D;
        lower[f] = -flow * share[f] - D;
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

FACE_SUM outflow(int f, double out, const double *phi)
{
    return out * phi[f];
}

/* Diagonal and right side of the cells, boundaries aside. */
static void cell_coefficients(int first, int last, struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;
    double *restrict diag = ps->diag, *restrict defect = ps->defect;

    ldu_row_sums(first, last, ps->momentum, diag);
    for (int c = first; c < last; c++) {
        diag[c] = ps->storage[c] - diag[c];
        defect[c] = mass_change(ps, c) * m->V[c] / fl->options.dt;
    }
    CELLS_SUM(ps->runs, first, last, m->cell_start, m->cell_face, m->out,
              defect, outflow, ps->carry);
    for (int c = first; c < last && ps->storage_older != NULL; c++)
        diag[c] += ps->storage_older[c];
    for (int i = 3 * first; i < 3 * last; i++)
        ps->b[i] = ps->owed[i];
}

/* [XS11 3.13, 3.14]: the explicit part of the drag to the right, the implicit
 * part on the diagonal. */
static void add_drag(int first, int last, struct fluid *fl)
{
    const double *restrict V = fl->mesh->V, *restrict F = fl->F;
    struct piso *const ps = fl->piso;

    for (int c = first; c < last; c++)
        ps->diag[c] += fl->K[c] * V[c];
    triples_add(last - first, 1.0, V + first, F + 3L * first,
                ps->b + 3L * first);
}

/* Fluid enters with the velocity that carries phi through the fluid's share
 * of the face. */
static void add_inlet_face(struct fluid *fl, int f)
{
    const struct mesh *const m = fl->mesh;
    const double *const S = &m->S[3 * f], phi = fl->piso->carry[f];
    const int c = m->owner[f];
    const double SS = S[0] * S[0] + S[1] * S[1] + S[2] * S[2];
    const double a = fl->options.mu * fl->piso->link[f] - fl->options.rho * phi;

    fl->piso->diag[c] += a;
    for (int k = 0; k < 3; k++)
        fl->piso->b[3 * c + k] += a * phi * S[k] / (fl->eps[c] * SS);
}

/* A wall, which may move along itself. */
static void add_wall_face(struct fluid *fl, const double wall[3], int f)
{
    const int c = fl->mesh->owner[f];
    const double D = fl->options.mu * fl->piso->link[f];

    fl->piso->diag[c] += D;
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
        fl->piso->diag[c] -= fl->options.rho * phi;
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
    const double D = fl->options.mu * fl->piso->link[f];

    const int c = m->owner[f];

    for (int k = 0; k < 3; k++)
        fl->piso->diag3[3 * c + k] += D * S[k] * S[k] / SS;
}

/* Three diagonals a cell, equal until slip walls add theirs. */
static void spread_diagonal(int first, int last, struct piso *ps)
{
    triples_spread(last - first, ps->diag + first, ps->diag3 + 3L * first);
}

/* What the slip walls have added, and what divides the velocity. H has their
 * part with the velocity from before. Where viscosity crosses the cell within a
 * step that would overshoot from one corrector to the next, and it is held back
 * with the new velocity. */
static void slip_diagonal(int first, int last, struct piso *ps)
{
    for (int c = first; c < last; c++)
        for (int i = 3 * c; i < 3 * c + 3; i++) {
            const double slip = ps->diag3[i] - ps->diag[c];
            const int stiff = slip > 0.25 * ps->storage[c];
            ps->slip[i] = slip;
            ps->held[i] = stiff ? slip : 0.0;
        }
}

static void add_slip_faces(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        if (fl->options.boundaries[i].kind != BOUNDARY_SLIP) continue;
        for (int f = p->first; f < p->first + p->n; f++)
            add_slip_face(fl, f);
    }
    STRIPS_RUN(m->n_cells, 12, slip_diagonal, fl->piso);
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
    STRIPS_RUN(m->n_cells, 4, spread_diagonal, ps);
    if (ps->slip != NULL) add_slip_faces(fl);
}

/* [XS11 2.8] without its pressure; with eps = 1 and no particles [LS 3.13]. */
void momentum_assemble(struct fluid *fl)
{
    STRIPS_RUN(fl->mesh->n_internal, 4, link_coefficients, fl);
    ldu_update(fl->piso->momentum);
    STRIPS_RUN(fl->mesh->n_cells, 12, cell_coefficients, fl);
    if (fl->options.coupled) {
        STRIPS_RUN(fl->mesh->n_cells, 12, add_drag, fl);
        jump_update(fl);
    }
    if (fl->piso->slope != NULL) deferred_add(fl);
    add_boundaries(fl);
}
