/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/multigrid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "linear/matrix.h"
#include "linear/multigrid/level_matrix.h"
#include "linear/multigrid/graph.h"
#include "linear/reduce.h"

/* --- one level, and the map from unknowns and links of the finer one --- */

/* A sum over members: entry i is the sum of the members list[start[i]] ..
 * list[start[i + 1] - 1], each times its weight. */
struct level_members {
    int *start, *list;
    float *weight; /* [-] */
};

struct level {
    int n, n_links;
    struct symmetric *A;
    /* The coefficient of each link, minus the entry; and the row sums of A, the
     * coefficients to a given value outside. On the finest level they are those
     * of the caller, while the matrix is set; on the others its own. */
    const double *g, *sums;
    double *own_g, *own_sums;
    float *b, *r; /* right-hand side, padded; residual */
    float *x, *y; /* two stages of the solution, padded */
    int *parent;  /* [-] aggregate of each unknown */
    struct level_members
        links; /* finer links summed into each link; the weight is the length of
                  the finer link over that of the coarser */
    struct level_members
        cells; /* finer unknowns summed into each unknown; the weight is the
                  same ratio of lengths for coefficients to a wall, 1 inside */
};

/* For each group the list of its members, in ascending order. */
static struct level_members members_of(void *owner, int n_groups, int n,
                                       const int *group)
{
    struct level_members m = {owner_ints(owner, n_groups + 1), NULL, NULL};
    int *const next = alloc_ints(n_groups + 1);

    for (int i = 0; i < n; i++)
        if (group[i] >= 0) m.start[group[i] + 1]++;
    for (int s = 0; s < n_groups; s++)
        m.start[s + 1] += m.start[s];
    for (int s = 0; s < n_groups; s++)
        next[s] = m.start[s];
    m.list = owner_ints(owner, m.start[n_groups]);
    m.weight = owner_zeroed(owner, (size_t)m.start[n_groups], sizeof *m.weight);
    for (int i = 0; i < n; i++)
        if (group[i] >= 0) m.list[next[group[i]]++] = i;
    free(next);
    return m;
}

/* A level with the unknowns and links of a graph. */
static void level_init(void *owner, struct level *v, const struct graph *g,
                       int finest)
{
    v->n = g->n;
    v->n_links = g->n_links;
    v->A = owner_join(owner, symmetric_create(g->n, g->n_links, g->owner,
                                              g->neighbour, finest));
    if (!finest) {
        v->g = v->own_g = owner_doubles(owner, g->n_links);
        v->sums = v->own_sums = owner_doubles(owner, g->n);
    }
    v->r = owner_zeroed(owner, (size_t)g->n, sizeof *v->r);
    v->b = symmetric_vector(v->A);
    v->x = symmetric_vector(v->A);
    v->y = symmetric_vector(v->A);
}

/* The factor of the coefficient between cell i and a wall on the coarser level,
 * where the distance from the wall is that of the aggregate I [-]. */
static float wall_factor(const struct graph *fine, int i,
                         const struct graph *coarse, int I)
{
    const double depth = graph_depth(fine, i);

    return depth > 0.0 ? (float)fmin(1.0, depth / graph_depth(coarse, I))
                       : 1.0F;
}

/* Sets the map from the finer level to v, the level of the graph `coarse`. */
static void level_connect(void *owner, struct level *v,
                          const struct graph *fine, const struct graph *coarse,
                          const int *parent, const int *bundle)
{
    struct level_members *const links = &v->links, *const cells = &v->cells;

    *links = members_of(owner, coarse->n_links, fine->n_links, bundle);
    for (int L = 0; L < coarse->n_links; L++)
        for (int s = links->start[L]; s < links->start[L + 1]; s++)
            links->weight[s] =
                (float)fmin(1.0, graph_length(fine, links->list[s]) /
                                     graph_length(coarse, L));
    *cells = members_of(owner, coarse->n, fine->n, parent);
    for (int I = 0; I < coarse->n; I++)
        for (int s = cells->start[I]; s < cells->start[I + 1]; s++)
            cells->weight[s] = wall_factor(fine, cells->list[s], coarse, I);
}

/* coarse[i] = the weighted sum of the members of i among the fine. */
static void level_gather(int first, int last, const struct level_members *m,
                         const double *fine, double *coarse)
{
    for (int i = first; i < last; i++) {
        double sum = 0.0;

        for (int s = m->start[i]; s < m->start[i + 1]; s++)
            sum += (double)m->weight[s] * fine[m->list[s]];
        coarse[i] = sum;
    }
}

/* The coefficients and row sums of a coarser level: the Galerkin sums over the
 * finer one. unit as in level_matrix.h. */
static void level_galerkin_coarsen(struct level *v, const struct level *fine,
                                   double unit)
{
    PARALLEL_RANGES(v->n_links, 8, level_gather, &v->links, fine->g, v->own_g);
    PARALLEL_RANGES(v->n, 8, level_gather, &v->cells, fine->sums, v->own_sums);
    symmetric_fill(v->A, v->g, v->sums, unit);
}

static void restrict_rows(int first, int last, struct level *v, const float *r)
{
    const int *const start = v->cells.start, *const list = v->cells.list;

    for (int I = first; I < last; I++) {
        float sum = 0.0F;

        for (int s = start[I]; s < start[I + 1]; s++)
            sum += r[list[s]];
        v->b[I] = sum;
    }
}

/* The right-hand side of v is the residual of the finer level, summed. */
static void level_restrict(struct level *v, const struct level *fine)
{
    PARALLEL_RANGES(v->n, 8, restrict_rows, v, fine->r);
}

static void prolong_rows(int first, int last, struct level *fine,
                         const float *y)
{
    for (int i = first; i < last; i++)
        fine->y[i] += y[fine->parent[i]];
}

/* The solution of v is added to the solution y of the finer level. */
static void level_prolong(const struct level *v, struct level *fine)
{
    PARALLEL_RANGES(fine->n, 1, prolong_rows, fine, v->y);
}

/* --- all levels --- */

enum {
    LEVELS = 40,        /* at most */
    DENSE = 64,         /* unknowns that are solved directly */
    COARSEST_SWEEPS = 8 /* sweeps on the coarsest level if it is larger and
                           cannot be coarsened */
};

/* Chebyshev smoothing of degree two damps the eigenvalues of D^-1 A between
 * low and high. high = 2 is Gershgorin's bound for a matrix that is weakly
 * diagonally dominant, so no eigenvalue needs to be estimated. */
static const double low = 0.56, high = 2.0;

struct multigrid {
    int n_levels;
    struct level level[LEVELS]; /* the finest first */
    struct dense *coarsest;     /* NULL if too many unknowns are left */
    struct graph *links;        /* of the coarsest level, for its matrix */
    double *unknown;            /* of the coarsest level */
    double unit;                /* one over the typical entry of the matrix */
    double scale;               /* of y of the finest level, after a cycle */
};

/* Adds the level above g, which it frees, and returns its graph; or NULL if the
 * aggregates are more than 0.8 of the unknowns of g. The level of g itself is
 * made last, because to coarsen a graph takes the most memory. */
static struct graph *add_level(struct multigrid *mg, struct graph *g)
{
    struct level *const v = &mg->level[mg->n_levels];
    int *const parent = v[-1].parent = owner_ints(mg, g->n);
    int *const bundle = alloc_ints(g->n_links);
    struct graph *coarse = graph_coarsened(g, parent, bundle);

    if (coarse->n > 0.8 * g->n) {
        owner_free(coarse);
        coarse = NULL;
    } else {
        level_connect(mg, v, g, coarse, parent, bundle);
        mg->n_levels++;
    }
    free(bundle);
    level_init(mg, &v[-1], g, &v[-1] == mg->level);
    owner_free(g);
    return coarse;
}

void *multigrid_create(int n, int n_links, const int *owner,
                       const int *neighbour, const double *strength,
                       const double *link, const double *V)
{
    struct multigrid *const mg = owner_create(sizeof *mg);
    struct graph *g =
        graph_create(n, n_links, owner, neighbour, strength, link, V);

    mg->n_levels = 1;
    while (g != NULL && g->n > DENSE && mg->n_levels < LEVELS)
        g = add_level(mg, g);
    if (g != NULL)
        level_init(mg, &mg->level[mg->n_levels - 1], g, mg->n_levels == 1);
    mg->links = owner_join(mg, g);

    const int left = mg->level[mg->n_levels - 1].n;

    if (left <= DENSE) mg->coarsest = owner_join(mg, dense_create(left));
    mg->unknown = owner_doubles(mg, left);
    return mg;
}

/* Factors the coarsest matrix, in double, from the coefficients of its links.
 */
static void factor_coarsest(struct multigrid *mg)
{
    const struct level *const v = &mg->level[mg->n_levels - 1];
    double *const a = mg->coarsest->a;
    const int n = v->n;

    for (int i = 0; i < n * n; i++)
        a[i] = 0.0;
    for (int i = 0; i < n; i++)
        a[i * n + i] = mg->unit * v->sums[i];
    for (int l = 0; l < v->n_links; l++) {
        const int i = mg->links->owner[l], j = mg->links->neighbour[l];
        const double g = mg->unit * v->g[l];

        a[i * n + i] += g;
        a[j * n + j] += g;
        a[i * n + j] -= g;
        a[j * n + i] -= g;
    }
    dense_factor(mg->coarsest);
}

/* The root of the mean of x_i^2. */
static double rms(int n, const double *x)
{
    return sqrt(reduce_dot(n, x, x) / n);
}

void multigrid_set_coefficients(void *matrix, const double *g,
                                const double *sums)
{
    struct multigrid *const mg = matrix;
    struct level *const v = mg->level;

    mg->unit = 1.0 / (v->n_links > 0 ? rms(v->n_links, g) : rms(v->n, sums));
    v->g = g;
    v->sums = sums;
    symmetric_fill(v->A, g, sums, mg->unit);
    for (int k = 1; k < mg->n_levels; k++)
        level_galerkin_coarsen(&v[k], &v[k - 1], mg->unit);
    if (mg->coarsest != NULL) factor_coarsest(mg);
}

/* The weights of Chebyshev smoothing [Saad03, 12.3.2]. */
static struct level_smoothing smoothing(void)
{
    const double theta = 0.5 * (high + low), delta = 0.5 * (high - low);
    const double rho0 = delta / theta;
    const double rho1 = 1.0 / (2.0 * theta / delta - rho0);
    const struct level_smoothing w = {(float)(1.0 / theta),
                                      (float)(rho1 * rho0),
                                      (float)(2.0 * rho1 / delta)};

    return w;
}

/* x = weight D^-1 b over a range. */
static void jacobi_rows(int first, int last, struct level *v, float weight)
{
    for (int i = first; i < last; i++)
        v->x[i] = weight * v->A->inverse[i] * v->b[i];
}

/* Two stages of smoothing of A y = b, from y = 0. */
static void smooth_from_zero(struct level *v)
{
    const struct level_smoothing w = smoothing();

    PARALLEL_RANGES(v->n, 1, jacobi_rows, v, w.first);
    symmetric_relax(v->A, v->b, v->x, 1.0F + w.previous, v->x, 0.0F, w.second,
                    v->y);
}

/* The same from the present y. */
static void multigrid_smooth(struct level *v)
{
    const struct level_smoothing w = smoothing();

    symmetric_relax(v->A, v->b, v->y, 1.0F, v->y, 0.0F, w.first, v->x);
    symmetric_relax(v->A, v->b, v->x, 1.0F + w.previous, v->y, -w.previous,
                    w.second, v->y);
}

/* Solves the coarsest level by elimination, or by many sweeps where it is
 * large. */
static void solve_coarsest(struct multigrid *mg)
{
    struct level *const v = &mg->level[mg->n_levels - 1];

    if (mg->coarsest == NULL) {
        smooth_from_zero(v);
        for (int s = 1; s < COARSEST_SWEEPS; s++)
            multigrid_smooth(v);
        return;
    }
    for (int i = 0; i < v->n; i++)
        mg->unknown[i] = (double)v->b[i];
    dense_solve(mg->coarsest, mg->unknown, mg->unknown);
    for (int i = 0; i < v->n; i++)
        v->y[i] = (float)mg->unknown[i];
}

static void level_descend(struct level *v)
{
    if (symmetric_descend(v->A, v->b, smoothing(), v->y, v->r)) return;
    smooth_from_zero(v);
    symmetric_residual(v->A, v->b, v->y, v->r);
}

static void level_ascend(const struct level *coarse, struct level *v)
{
    if (symmetric_ascend(v->A, v->b, smoothing(), v->parent, coarse->y, v->x,
                         v->y))
        return;
    level_prolong(coarse, v);
    multigrid_smooth(v);
}

/* One V-cycle: each level is smoothed, its residual is restricted to the
 * coarser level, the correction is prolonged, and the level is smoothed again.
 */
static void cycle(struct multigrid *mg)
{
    struct level *const v = mg->level;

    for (int k = 0; k + 1 < mg->n_levels; k++) {
        level_descend(&v[k]);
        level_restrict(&v[k + 1], &v[k]);
    }
    solve_coarsest(mg);
    for (int k = mg->n_levels - 2; k >= 0; k--)
        level_ascend(&v[k + 1], &v[k]);
}

/* b = r / scale over a range */
static void copy_in(int first, int last, const double *r, double scale,
                    float *b)
{
    for (int i = first; i < last; i++)
        b[i] = (float)(r[i] / scale);
}

/* M r, which stays in y of the finest level, over mg->scale; returns r.M r. */
static double multigrid_kind_apply(void *matrix, const double *r, double rr)
{
    struct multigrid *const mg = matrix;
    struct level *const v = mg->level;
    const double scale = sqrt(rr / v->n);
    double rz;

    if (scale > 0.0) {
        PARALLEL_RANGES(v->n, 1, copy_in, r, scale, v->b);
        cycle(mg);
    }
    mg->scale = scale * mg->unit;
    PARALLEL_SUM(rz, v->n, 1, reduce_range_scaled, r, v->y, mg->scale);
    return rz;
}

/* p = scale y + beta p over a range */
static void direction_rows(int first, int last, const float *y, double scale,
                           double beta, double *p)
{
    for (int i = first; i < last; i++)
        p[i] = scale * (double)y[i] + beta * p[i];
}

/* The new direction: the preconditioned residual plus beta times the old. */
static void multigrid_kind_direction(const void *matrix, const double *r,
                                     double beta, double *p)
{
    const struct multigrid *const mg = matrix;

    (void)r;
    PARALLEL_RANGES(mg->level->n, 1, direction_rows, mg->level->y, mg->scale,
                    beta, p);
}

double multigrid_apply(struct multigrid *mg, const double *r, double *z)
{
    const int n = mg->level->n;
    const double rz = multigrid_kind_apply(mg, r, reduce_dot(n, r, r));

    memset(z, 0, (size_t)n * sizeof *z);
    multigrid_kind_direction(mg, r, 0.0, z);
    return rz;
}

/* On a box several times faster than csr_multiply; equal to it up to rounding.
 */
static double multigrid_multiply(const void *matrix, const double *x, double *y)
{
    const struct multigrid *const mg = matrix;

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

const struct preconditioned_kind multigrid_preconditioned = {
    .name = "multigrid",
    .create = multigrid_create,
    .set = multigrid_set_coefficients,
    .multiply = multigrid_multiply,
    .apply = multigrid_kind_apply,
    .direction = multigrid_kind_direction,
};
