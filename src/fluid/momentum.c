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
static void add_drag(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    struct piso *const ps = fl->piso;

    for (int c = 0; c < m->n_cells; c++) {
        ps->diag[c] += fl->K[c] * m->V[c];
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
            const double D = fl->options.mu * fl->piso->link[f];
            for (int k = 0; k < 3; k++)
                right[3 * m->owner[f] + k] -=
                    D * S[k] * (Su - S[k] * u[k]) / SS;
        }
    }
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
    STRIPS_RUN(m->n_cells, 4, slip_diagonal, fl->piso);
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
        add_drag(fl);
        jump_update(fl);
    }
    if (fl->piso->slope != NULL) deferred_add(fl);
    add_boundaries(fl);
}

/* Blocks of cells whose numbers stay in the nearest cache. */
static int block_end(int first, int last)
{
    return first + TRIPLES < last ? first + TRIPLES : last;
}

/* gamma V of a block's cells, three times each. */
static void spread_shares(int first, int last, const struct fluid *fl,
                          double *share3)
{
    double share[TRIPLES];

    for (int c = first; c < last; c++)
        share[c - first] = piso_gamma(fl, c) * fl->mesh->V[c];
    triples_spread(last - first, share, share3);
}

/* right = to and what stays on the right beside it for a given pressure [N]:
 * the past, and -gamma V grad p; for a block of cells. */
static void add_known(int first, int last, const struct fluid *fl,
                      const double *restrict to, double *restrict right)
{
    const double *restrict past = fl->piso->past + 3L * first;
    const double *restrict grad_p = fl->grad_p + 3L * first;
    double share[3 * TRIPLES];

    spread_shares(first, last, fl, share);
    for (int i = 0; i < 3 * (last - first); i++)
        right[i] = to[i] + (past[i] - share[i] * grad_p[i]);
}

static void known_rows(int first, int last, const struct fluid *fl)
{
    const struct piso *const ps = fl->piso;

    for (int end; first < last; first = end) {
        end = block_end(first, last);
        add_known(first, end, fl, ps->b + 3L * first, ps->rhs + 3L * first);
    }
}

struct solve_report momentum_predict(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    STRIPS_RUN(fl->mesh->n_cells, 12, known_rows, fl);
    if (ps->oblique_slip) add_slip_rest(fl, ps->rhs);
    const double tolerance = fl->options.predictor > 0.0
                                 ? fl->options.predictor
                                 : fl->options.tolerance;

    return bicgstab_solve(ps->momentum, ps->diag3, ps->rhs, fl->u, tolerance,
                          1e-300, 200, ps->bicgstab);
}

/* H = b - slip u - sum a_N u_N after the prediction: the sum is what rhs, the
 * diagonal and the solver's residual leave. */
static void predicted_rows(int first, int last, const struct fluid *fl,
                           const double *residual)
{
    const struct piso *const ps = fl->piso;

    for (int end; first < last; first = end) {
        const long at = 3L * first;
        const double *restrict b = ps->b + at, *restrict rhs = ps->rhs + at;
        const double *restrict u = fl->u + at, *restrict r = residual + at;
        double *restrict H = ps->H + at, diag[3 * TRIPLES];
        end = block_end(first, last);
        triples_spread(end - first, ps->diag + first, diag);
        for (int i = 0; i < 3 * (end - first); i++)
            H[i] = b[i] - rhs[i] + r[i] + diag[i] * u[i];
    }
}

void momentum_predicted(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    STRIPS_RUN(fl->mesh->n_cells, 12, predicted_rows, fl,
               bicgstab_residual(ps->bicgstab));
    if (ps->oblique_slip) add_slip_rest(fl, ps->H);
}

/* H = b - slip u - sum a_N u_N */
static void neighbour_rows(int first, int last, const struct fluid *fl)
{
    const struct piso *const ps = fl->piso;
    const double *restrict b = ps->b, *restrict u = fl->u;
    double *restrict H = ps->H;

    ldu_rows(first, last, ps->momentum, NULL, u, H);
    for (int i = 3 * first; i < 3 * last; i++)
        H[i] = b[i] - H[i];
    for (int i = 3 * first; i < 3 * last && ps->slip != NULL; i++)
        H[i] -= ps->slip[i] * u[i];
}

void momentum_neighbours(struct fluid *fl)
{
    struct piso *const ps = fl->piso;

    STRIPS_RUN(fl->mesh->n_cells, 12, neighbour_rows, fl);
    if (ps->oblique_slip) add_slip_rest(fl, ps->H);
}

static void correct_rows(int first, int last, struct fluid *fl)
{
    const struct piso *const ps = fl->piso;

    for (int end; first < last; first = end) {
        const long at = 3L * first;
        double *restrict u = fl->u + at;
        double right[3 * TRIPLES], a[3 * TRIPLES];
        end = block_end(first, last);
        const int n = 3 * (end - first);
        add_known(first, end, fl, ps->H + at, right);
        triples_spread(end - first, ps->diag + first, a);
        for (int i = 0; i < n && ps->held != NULL; i++) {
            right[i] += ps->held[at + i] * u[i];
            a[i] += ps->held[at + i];
        }
        for (int i = 0; i < n; i++)
            u[i] = right[i] / a[i];
    }
}

void momentum_correct(struct fluid *fl)
{
    STRIPS_RUN(fl->mesh->n_cells, 12, correct_rows, fl);
}

/* The largest of what is left and of the terms, one pair a strip. */
struct rest {
    double worst, largest; /* [N] */
};

static double larger(double a, double b)
{
    return b > a ? b : a;
}

static void rest_rows(int first, int last, struct fluid *fl, struct rest *rest)
{
    struct piso *const ps = fl->piso;
    struct rest r = {0.0, 0.0};
    const int strip = strips_of(fl->mesh->n_cells, first);

    for (int end; first < last; first = end) {
        const long at = 3L * first;
        const double *restrict u = fl->u + at;
        double *restrict owed = ps->owed + at;
        double right[3 * TRIPLES], a[3 * TRIPLES];
        end = block_end(first, last);
        add_known(first, end, fl, ps->H + at, right);
        triples_spread(end - first, ps->diag + first, a);
        for (int i = 0; i < 3 * (end - first); i++) {
            owed[i] = right[i] - a[i] * u[i];
            r.worst = larger(r.worst, fabs(owed[i]));
            r.largest = larger(r.largest, fabs(a[i] * u[i]));
        }
    }
    rest[strip] = r;
}

double momentum_rest(struct fluid *fl)
{
    const int n = fl->mesh->n_cells;
    struct rest rest[STRIPS] = {{0.0, 0.0}}, all = {0.0, 0.0};

    momentum_neighbours(fl);
    STRIPS_RUN(n, 12, rest_rows, fl, rest);
    for (int s = 0; s < STRIPS; s++) {
        all.worst = fmax(all.worst, rest[s].worst);
        all.largest = fmax(all.largest, rest[s].largest);
    }
    return all.largest > 0.0 ? all.worst / all.largest : 0.0;
}
