/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/pairwise_aggregation.h"

#include "base/alloc.h"
#include "linear/csr.h"

#include <math.h>
#include <stdlib.h>

/* A link is strong if its S/d is at least this fraction of the largest of
 * either of its cells [-]. */
static const double strong_fraction = 0.4;

/* The axis (0, 1, 2) to which the link is closest; where only rounding tells
 * two axes apart, the first of them. */
static int pairwise_aggregation_axis_of(const struct graph *g, int l)
{
    const double *const d = g->distance + 3L * l;
    int axis = 0;

    for (int k = 1; k < 3; k++)
        if (fabs(d[k]) > 1.001 * fabs(d[axis])) axis = k;
    return axis;
}

static void mark_strong(struct graph *g)
{
    double *const most = alloc_doubles(g->n);

    for (int l = 0; l < g->n_links; l++) {
        const int i = g->owner[l], j = g->neighbour[l];

        if (i == j) continue;
        most[i] = fmax(most[i], g->strength[l]);
        most[j] = fmax(most[j], g->strength[l]);
    }
    for (int l = 0; l < g->n_links; l++) {
        const int i = g->owner[l], j = g->neighbour[l];

        g->strong[l] = i != j && g->strength[l] >=
                                     strong_fraction * fmin(most[i], most[j]);
    }
    free(most);
}

/* The strong links along one axis as a csr: the columns of a row are the linked
 * cells, a[] holds the strengths S/d, and link_at[e] is the link of entry e. */
static struct csr *strong_links(const struct graph *g, int axis, int **link_at)
{
    int *const own = alloc_ints(g->n_links), *const nei =
                                                 alloc_ints(g->n_links);
    int *const which = alloc_ints(g->n_links);
    int n = 0;

    for (int l = 0; l < g->n_links; l++) {
        if (!g->strong[l] || pairwise_aggregation_axis_of(g, l) != axis)
            continue;
        own[n] = g->owner[l];
        nei[n] = g->neighbour[l];
        which[n++] = l;
    }

    struct csr *const A = csr_create(g->n, n, own, nei);

    *link_at = alloc_ints(2 * n);
    for (int l = 0; l < n; l++) {
        A->a[A->upper[l]] = A->a[A->lower[l]] = g->strength[which[l]];
        (*link_at)[A->upper[l]] = (*link_at)[A->lower[l]] = which[l];
    }
    free(own);
    free(nei);
    free(which);
    return A;
}

/* The entry of row i that leads to the strongest cell of those whose mate is
 * (free = 1) or is not (free = 0) still to be found, or -1. Differences within
 * rounding do not count: the first wins. */
static int strongest(const struct csr *A, const int *mate, int i, int free_one)
{
    int best = -1;

    for (int e = A->start[i]; e < A->start[i + 1]; e++) {
        const int j = A->col[e];

        if (j == i || (mate[j] < 0) != free_one) continue;
        if (best < 0 || A->a[e] > 1.001 * A->a[best]) best = e;
    }
    return best;
}

/* Sets the offset of cell j from the first cell of its aggregate, through link
 * l from cell i. */
static void set_offset(const struct graph *g, int l, int i, int j,
                       double *offset)
{
    const double sign = g->owner[l] == i ? 1.0 : -1.0;

    for (int k = 0; k < 3; k++)
        offset[3L * j + k] =
            offset[3L * i + k] + sign * g->distance[3L * l + k];
}

/* Joins cells in pairs along one axis, and each cell that is left over to the
 * pair of a neighbour; root and offset as in graph_aggregated. */
static void join_pairs(const struct graph *g, int axis, int *root,
                       double *offset)
{
    int *link_at = NULL;
    struct csr *const A = strong_links(g, axis, &link_at);
    int *const mate = alloc_ints(g->n);

    for (int i = 0; i < g->n; i++)
        mate[i] = -1;
    for (int i = 0; i < g->n; i++) {
        const int e = mate[i] < 0 ? strongest(A, mate, i, 1) : -1;

        root[i] = mate[i] < 0 ? i : root[i];
        if (e < 0) continue;
        mate[i] = A->col[e];
        mate[A->col[e]] = i;
        root[A->col[e]] = i;
        set_offset(g, link_at[e], i, A->col[e], offset);
    }
    for (int i = 0; i < g->n; i++) {
        const int e = mate[i] < 0 ? strongest(A, mate, i, 0) : -1;

        if (e < 0) continue;
        root[i] = root[A->col[e]];
        set_offset(g, link_at[e], A->col[e], i, offset);
    }
    free(mate);
    free(link_at);
    csr_free(A);
}

/* The graph after the cells have been paired along one axis. */
static struct graph *pair_along_axis(const struct graph *g, int axis,
                                     int *parent, int *bundle)
{
    int *const root = alloc_ints(g->n);
    double *const offset = alloc_doubles(3 * g->n);

    join_pairs(g, axis, root, offset);

    struct graph *const big = graph_aggregated(g, root, offset, parent, bundle);

    free(root);
    free(offset);
    return big;
}

/* map[i] = next[map[i]]; an entry of -1 stays. */
static void follow(int n, int *map, const int *next)
{
    for (int i = 0; i < n; i++)
        if (map[i] >= 0) map[i] = next[map[i]];
}

struct graph *pairwise_aggregation_coarsen(struct graph *g, int *parent,
                                           int *bundle)
{
    struct graph *big = NULL;
    int *const p = alloc_ints(g->n), *const b = alloc_ints(g->n_links);

    mark_strong(g);
    for (int axis = 0; axis < 3; axis++) {
        struct graph *const before = big;

        if (before == NULL) {
            big = pair_along_axis(g, axis, parent, bundle);
            continue;
        }
        big = pair_along_axis(before, axis, p, b);
        follow(g->n, parent, p);
        follow(g->n_links, bundle, b);
        graph_free(before);
    }
    free(p);
    free(b);
    return big;
}
