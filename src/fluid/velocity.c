/* SPDX-License-Identifier: GPL-3.0-or-later */
/* velocity.c -- the velocity from the momentum equation and a pressure:
 * predicted, corrected, and what is left of the equation.
 */
#include "fluid/piso.h"

#include <math.h>

#include "linear/triples.h"

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

struct solve_report velocity_predict(struct fluid *fl)
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

void velocity_predicted(struct fluid *fl)
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

void velocity_neighbours(struct fluid *fl)
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

void velocity_correct(struct fluid *fl)
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

double velocity_rest(struct fluid *fl)
{
    const int n = fl->mesh->n_cells;
    struct rest rest[STRIPS] = {{0.0, 0.0}}, all = {0.0, 0.0};

    velocity_neighbours(fl);
    STRIPS_RUN(n, 12, rest_rows, fl, rest);
    for (int s = 0; s < STRIPS; s++) {
        all.worst = fmax(all.worst, rest[s].worst);
        all.largest = fmax(all.largest, rest[s].largest);
    }
    return all.largest > 0.0 ? all.worst / all.largest : 0.0;
}
