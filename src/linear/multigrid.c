/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid.h"

#include "base/alloc.h"
#include "linear/dense.h"
#include "linear/graph.h"
#include "linear/pairs.h"
#include "linear/reduce.h"
#include "linear/symmetric.h"

#include <math.h>
#include <stdlib.h>

enum {
    LEVELS = 40,        /* at most */
    DENSE = 64,         /* unknowns that are solved directly */
    COARSEST_SWEEPS = 8 /* smoothings if there are more and no way down */
};

/* Chebyshev smoothing of degree two damps the eigenvalues of D^-1 A between
 * low and high. high = 2 is Gershgorin's bound for a matrix that is weakly
 * diagonally dominant, so no eigenvalue needs to be estimated. */
static const double low = 0.56, high = 2.0;

/* What sums many things into few: item t of list[start[i]] .. belongs to i. */
struct members {
    int *start, *list;
};

struct level {
    int n, n_links;
    struct symmetric *A;
    double *g;            /* coefficient of each link: minus the matrix entry */
    double *sums;         /* row sums of the matrix: what is not diffusion */
    float *b, *r;         /* right-hand side, residual */
    float *x, *y;         /* two stages of the solution, padded */
    int *parent;          /* [-] aggregate of each unknown */
    struct members cells; /* of the finer level, in each unknown */
    struct members links; /* of the finer level, in each link */
    double *link_share;   /* [-] of links.list: length of the finer link over
                             that of the coarser */
    double *cell_share;   /* [-] of cells.list: the same for what leads to a
                             wall, 1 inside */
};

struct multigrid {
    int n_levels;
    struct level level[LEVELS];
    struct dense *coarsest; /* NULL if too many unknowns are left */
    double *unknown;        /* of the coarsest level */
    double unit;            /* one over the largest entry of the matrix */
};

static struct members members_of(int n_groups, int n, const int *group)
{
    struct members m = {alloc_ints(n_groups + 1), NULL};
    int *const next = alloc_ints(n_groups + 1);

    for (int i = 0; i < n; i++)
        if (group[i] >= 0) m.start[group[i] + 1]++;
    for (int s = 0; s < n_groups; s++)
        m.start[s + 1] += m.start[s];
    for (int s = 0; s < n_groups; s++)
        next[s] = m.start[s];
    m.list = alloc_ints(m.start[n_groups]);
    for (int i = 0; i < n; i++)
        if (group[i] >= 0) m.list[next[group[i]]++] = i;
    free(next);
    return m;
}

static float *alloc_floats(int n)
{
    return alloc_zeroed((size_t)n, sizeof(float));
}

static void level_fill(struct level *v, const struct graph *g, int finest)
{
    v->n = g->n;
    v->n_links = g->n_links;
    v->A = symmetric_create(g->n, g->n_links, g->owner, g->neighbour, finest);
    v->g = alloc_doubles(g->n_links);
    v->sums = alloc_doubles(g->n);
    v->b = alloc_floats(g->n);
    v->r = alloc_floats(g->n);
    v->x = symmetric_vector(v->A);
    v->y = symmetric_vector(v->A);
}

/* Ties level v to the finer level below it. */
static void level_tie(struct level *v, const struct graph *fine,
                      const struct graph *coarse, const int *parent,
                      const int *bundle)
{
    v->cells = members_of(coarse->n, fine->n, parent);
    v->links = members_of(coarse->n_links, fine->n_links, bundle);
    v->link_share = alloc_doubles(v->links.start[coarse->n_links]);
    v->cell_share = alloc_doubles(fine->n);
    for (int L = 0; L < coarse->n_links; L++)
        for (int s = v->links.start[L]; s < v->links.start[L + 1]; s++)
            v->link_share[s] = fmin(1.0, graph_length(fine, v->links.list[s]) /
                                             graph_length(coarse, L));
    for (int I = 0; I < coarse->n; I++)
        for (int s = v->cells.start[I]; s < v->cells.start[I + 1]; s++) {
            const double depth = graph_depth(fine, v->cells.list[s]);

            v->cell_share[s] =
                depth > 0.0 ? fmin(1.0, depth / graph_depth(coarse, I)) : 1.0;
        }
}

struct multigrid *multigrid_create(int n, int n_links, const int *owner,
                                   const int *neighbour, const double *strength,
                                   const double *link, const double *V)
{
    struct multigrid *const mg = alloc_zeroed(1, sizeof *mg);
    struct graph *g =
        graph_create(n, n_links, owner, neighbour, strength, link, V);

    level_fill(&mg->level[mg->n_levels++], g, 1);
    while (g->n > DENSE && mg->n_levels < LEVELS) {
        int *const parent = alloc_ints(g->n);
        int *const bundle = alloc_ints(g->n_links);
        struct graph *const big = pairs_coarser(g, parent, bundle);
        const int stalled = big->n > 0.8 * g->n;

        if (!stalled) {
            mg->level[mg->n_levels - 1].parent = parent;
            level_fill(&mg->level[mg->n_levels], big, 0);
            level_tie(&mg->level[mg->n_levels++], g, big, parent, bundle);
        } else {
            free(parent);
        }
        free(bundle);
        graph_free(g);
        g = big;
        if (stalled) break;
    }
    graph_free(g);

    const int left = mg->level[mg->n_levels - 1].n;

    if (left <= DENSE) mg->coarsest = dense_create(left);
    mg->unknown = alloc_doubles(left);
    return mg;
}

static void level_free(struct level *v)
{
    symmetric_vector_free(v->A, v->x);
    symmetric_vector_free(v->A, v->y);
    symmetric_free(v->A);
    free(v->g);
    free(v->sums);
    free(v->b);
    free(v->r);
    free(v->parent);
    free(v->cells.start);
    free(v->cells.list);
    free(v->links.start);
    free(v->links.list);
    free(v->link_share);
    free(v->cell_share);
}

void multigrid_free(struct multigrid *mg)
{
    if (mg == NULL) return;
    for (int k = 0; k < mg->n_levels; k++)
        level_free(&mg->level[k]);
    dense_free(mg->coarsest);
    free(mg->unknown);
    free(mg);
}

/* The largest |x_i|: the maximum does not depend on the order. */
static double largest(int n, const double *x)
{
    double most = 0.0;

#pragma omp parallel for schedule(static)                                      \
    reduction(max                                                              \
              : most) if (n > REDUCE_THREADED)
    for (int i = 0; i < n; i++)
        most = fabs(x[i]) > most ? fabs(x[i]) : most;
    return most;
}

/* The coefficients of the finest level, out of the matrix itself. */
static void take_over(struct level *v, const struct csr *A)
{
#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED / 4)
    for (int l = 0; l < v->n_links; l++)
        v->g[l] = -A->a[A->upper[l]];
#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED / 4)
    for (int i = 0; i < v->n; i++) {
        double sum = A->diag[i];

        for (int e = A->start[i]; e < A->start[i + 1]; e++)
            sum += A->a[e];
        v->sums[i] = sum;
    }
}

/* The coefficients of a coarser level, summed from the finer one. */
static void sum_up(struct level *v, const struct level *fine)
{
#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED / 16)
    for (int L = 0; L < v->n_links; L++) {
        double sum = 0.0;

        for (int s = v->links.start[L]; s < v->links.start[L + 1]; s++)
            sum += v->link_share[s] * fine->g[v->links.list[s]];
        v->g[L] = sum;
    }
#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED / 8)
    for (int I = 0; I < v->n; I++) {
        double sum = 0.0;

        for (int s = v->cells.start[I]; s < v->cells.start[I + 1]; s++)
            sum += v->cell_share[s] * fine->sums[v->cells.list[s]];
        v->sums[I] = sum;
    }
}

/* The coarsest matrix, column by column: its rows times unit vectors. */
static void factor_coarsest(struct multigrid *mg)
{
    struct level *const v = &mg->level[mg->n_levels - 1];
    double *const a = dense_matrix(mg->coarsest);

    for (int i = 0; i < v->n; i++)
        v->b[i] = v->x[i] = 0.0F;
    for (int j = 0; j < v->n; j++) {
        v->x[j] = -1.0F;
        symmetric_residual(v->A, v->b, v->x, v->r);
        v->x[j] = 0.0F;
        for (int i = 0; i < v->n; i++)
            a[j * v->n + i] = (double)v->r[i];
    }
    dense_factor(mg->coarsest);
}

void multigrid_update(struct multigrid *mg, const struct csr *A)
{
    mg->unit = 1.0 / largest(A->n, A->diag);
    for (int k = 0; k < mg->n_levels; k++) {
        struct level *const v = &mg->level[k];

        if (k == 0)
            take_over(v, A);
        else
            sum_up(v, v - 1);
        symmetric_fill(v->A, v->g, v->sums, mg->unit);
    }
    if (mg->coarsest != NULL) factor_coarsest(mg);
}

/* The weights of the two stages of Chebyshev smoothing [Saad 03, 12.3.2]. */
struct weights {
    float first, turn, second;
};

static struct weights smoothing(void)
{
    const double theta = 0.5 * (high + low), delta = 0.5 * (high - low);
    const double rho0 = delta / theta;
    const double rho1 = 1.0 / (2.0 * theta / delta - rho0);
    const struct weights w = {(float)(1.0 / theta), (float)(rho1 * rho0),
                              (float)(2.0 * rho1 / delta)};

    return w;
}

/* y = a smoothed solution of A y = b from zero. */
static void smooth_from_zero(const struct level *v)
{
    const struct weights w = smoothing();

#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED)
    for (int i = 0; i < v->n; i++)
        v->x[i] = w.first * v->A->inverse[i] * v->b[i];
    symmetric_relax(v->A, v->b, v->x, 1.0F + w.turn, v->x, 0.0F, w.second,
                    v->y);
}

static void smooth(const struct level *v)
{
    const struct weights w = smoothing();

    symmetric_relax(v->A, v->b, v->y, 1.0F, v->y, 0.0F, w.first, v->x);
    symmetric_relax(v->A, v->b, v->x, 1.0F + w.turn, v->y, -w.turn, w.second,
                    v->y);
}

/* Right-hand side of the coarser level: what the finer one is still missing. */
static void go_down(const struct level *fine, struct level *v)
{
    smooth_from_zero(fine);
    symmetric_residual(fine->A, fine->b, fine->y, fine->r);
#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED / 8)
    for (int I = 0; I < v->n; I++) {
        float sum = 0.0F;

        for (int s = v->cells.start[I]; s < v->cells.start[I + 1]; s++)
            sum += fine->r[v->cells.list[s]];
        v->b[I] = sum;
    }
}

static void go_up(const struct level *fine, const struct level *v)
{
#pragma omp parallel for schedule(static) if (fine->n > REDUCE_THREADED)
    for (int i = 0; i < fine->n; i++)
        fine->y[i] += v->y[fine->parent[i]];
    smooth(fine);
}

static void solve_coarsest(const struct multigrid *mg)
{
    const struct level *const v = &mg->level[mg->n_levels - 1];

    if (mg->coarsest == NULL) {
        smooth_from_zero(v);
        for (int s = 1; s < COARSEST_SWEEPS; s++)
            smooth(v);
        return;
    }
    for (int i = 0; i < v->n; i++)
        mg->unknown[i] = (double)v->b[i];
    dense_solve(mg->coarsest, mg->unknown, mg->unknown);
    for (int i = 0; i < v->n; i++)
        v->y[i] = (float)mg->unknown[i];
}

/* z = scale y; returns r.z. */
static double give(int n, const float *y, double scale, const double *r,
                   double *z)
{
    double strip[REDUCE_STRIPS];

#pragma omp parallel for schedule(static) if (n > REDUCE_THREADED)
    for (int s = 0; s < REDUCE_STRIPS; s++) {
        const int first = reduce_strip(n, s), last = reduce_strip(n, s + 1);

        for (int i = first; i < last; i++)
            z[i] = scale * (double)y[i];
        strip[s] = reduce_range(first, last, r, z);
    }
    return reduce_strips(strip);
}

double multigrid_apply(struct multigrid *mg, const double *r, double *z)
{
    struct level *const v = mg->level;
    const double scale = largest(v->n, r);

    if (scale == 0.0) return give(v->n, v->y, 0.0, r, z);
#pragma omp parallel for schedule(static) if (v->n > REDUCE_THREADED)
    for (int i = 0; i < v->n; i++)
        v->b[i] = (float)(r[i] / scale);
    for (int k = 0; k + 1 < mg->n_levels; k++)
        go_down(&v[k], &v[k + 1]);
    solve_coarsest(mg);
    for (int k = mg->n_levels - 2; k >= 0; k--)
        go_up(&v[k], &v[k + 1]);
    return give(v->n, v->y, scale * mg->unit, r, z);
}

double multigrid_multiply(const struct multigrid *mg, const double *x,
                          double *y)
{
    return symmetric_multiply(mg->level[0].A, x, y);
}

int multigrid_levels(const struct multigrid *mg)
{
    return mg->n_levels;
}

int multigrid_unknowns(const struct multigrid *mg, int level)
{
    return mg->level[level].n;
}
