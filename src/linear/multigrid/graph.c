/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/graph.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "linear/matrix.h"

/* A gap below this fraction of a cell's area is not treated as a wall [-]. */
static const double small_gap = 0.02;

static struct graph *allocate(int n, int n_links)
{
    struct graph *const g = owner_create(sizeof *g);

    g->n = n;
    g->n_links = n_links;
    g->owner = owner_ints(g, n_links);
    g->neighbour = owner_ints(g, n_links);
    g->strength = owner_doubles(g, n_links);
    g->distance = owner_doubles(g, 3 * n_links);
    g->V = owner_doubles(g, n);
    g->wall = owner_doubles(g, 3 * n);
    g->strong = owner_ints(g, n_links);
    return g;
}

/* The areas of a closed cell add up to zero, so the sum over its links is minus
 * the area of its walls. S is assumed to be parallel to d; a sum below
 * small_gap is taken for the error of that. */
static void graph_find_walls(struct graph *g)
{
    double *const area = alloc_doubles(g->n);

    for (int l = 0; l < g->n_links; l++)
        for (int k = 0; k < 3; k++) {
            const double S = g->strength[l] * g->distance[3L * l + k];
            const int i = g->owner[l], j = g->neighbour[l];

            g->wall[3L * i + k] -= S;
            g->wall[3L * j + k] += S;
            area[i] += fabs(S);
            area[j] += fabs(S);
        }
    for (int i = 0; i < g->n; i++)
        for (int k = 0; k < 3; k++) {
            double *const wall = &g->wall[3L * i + k];

            *wall = fabs(*wall) > small_gap * area[i] ? fabs(*wall) : 0.0;
        }
    free(area);
}

struct graph *graph_create(int n, int n_links, const int *owner,
                           const int *neighbour, const double *strength,
                           const double *link, const double *V)
{
    struct graph *const g = allocate(n, n_links);
    const size_t links = (size_t)n_links;

    memcpy(g->owner, owner, links * sizeof *owner);
    memcpy(g->neighbour, neighbour, links * sizeof *neighbour);
    memcpy(g->strength, strength, links * sizeof *strength);
    memcpy(g->distance, link, 3 * links * sizeof *link);
    memcpy(g->V, V, (size_t)n * sizeof *V);
    graph_find_walls(g);
    return g;
}

double graph_length(const struct graph *g, int l)
{
    const double *const d = g->distance + 3L * l;

    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

double graph_depth(const struct graph *g, int i)
{
    const double *const w = g->wall + 3L * i;
    const double area = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);

    return area > 0.0 ? g->V[i] / area : 0.0;
}

/* Numbers the aggregates in the order of their first cells; returns how many.
 */
static int graph_number(int n, const int *root, int *parent)
{
    int count = 0;

    for (int i = 0; i < n; i++)
        parent[i] = -1;
    for (int i = 0; i < n; i++) {
        if (parent[root[i]] < 0) parent[root[i]] = count++;
        parent[i] = parent[root[i]];
    }
    return count;
}

/* Sets the volumes and walls of the aggregates, and changes the offsets from
 * those from their first cells to those from their centroids. */
static void centre(const struct graph *g, const int *parent, struct graph *big,
                   double *offset)
{
    double *const sum = alloc_doubles(3 * big->n);

    for (int i = 0; i < g->n; i++) {
        big->V[parent[i]] += g->V[i];
        for (int k = 0; k < 3; k++) {
            big->wall[3L * parent[i] + k] += g->wall[3L * i + k];
            sum[3L * parent[i] + k] += g->V[i] * offset[3L * i + k];
        }
    }
    for (int i = 0; i < g->n; i++)
        for (int k = 0; k < 3; k++)
            offset[3L * i + k] -= sum[3L * parent[i] + k] / big->V[parent[i]];
    free(sum);
}

/* The number of the first of the two aggregates that link l joins. */
static int lower_aggregate(const struct graph *g, const int *parent, int l)
{
    const int I = parent[g->owner[l]], J = parent[g->neighbour[l]];

    return I < J ? I : J;
}

/* D = the vector between the centroids of the aggregates that link l joins,
 * from the one with the lower number [m]. */
static void between_centroids(const struct graph *g, const int *parent,
                              const double *offset, int l, double *D)
{
    const int i = g->owner[l], j = g->neighbour[l];
    const double sign = parent[i] < parent[j] ? 1.0 : -1.0;

    for (int k = 0; k < 3; k++)
        D[k] = sign * (g->distance[3L * l + k] + offset[3L * i + k] -
                       offset[3L * j + k]);
}

/* The coarse link from I to J along D, among those from first on; one is
 * created if there is none. */
static int find_bundle(struct graph *big, int first, int I, int J,
                       const double *D)
{
    int b = first;

    for (; b < big->n_links; b++) {
        const double *const E = big->distance + 3L * b;

        if (big->neighbour[b] == J &&
            D[0] * E[0] + D[1] * E[1] + D[2] * E[2] >= 0.0)
            return b;
    }
    big->n_links++;
    big->owner[b] = I;
    big->neighbour[b] = J;
    memcpy(big->distance + 3L * b, D, 3 * sizeof *D);
    return b;
}

/* The links, sorted by the lower number of the two aggregates that they join;
 * the caller frees the list. */
static int *sorted_by_lower(const struct graph *g, const int *parent, int count)
{
    int *const order = alloc_ints(g->n_links);
    int *const next = alloc_ints(count + 1);

    for (int l = 0; l < g->n_links; l++)
        next[lower_aggregate(g, parent, l) + 1]++;
    for (int I = 0; I < count; I++)
        next[I + 1] += next[I];
    for (int l = 0; l < g->n_links; l++)
        order[next[lower_aggregate(g, parent, l)]++] = l;
    free(next);
    return order;
}

/* Adds the links between each two aggregates to a coarse link. Its strength is
 * the sum of theirs, each times the ratio of its length to that of the coarse
 * link. */
static void bundle_links(const struct graph *g, const int *parent,
                         const double *offset, struct graph *big, int *bundle)
{
    int *const order = sorted_by_lower(g, parent, big->n);
    int first = 0, current = -1;

    big->n_links = 0;
    for (int s = 0; s < g->n_links; s++) {
        const int l = order[s];
        const int p = parent[g->owner[l]], q = parent[g->neighbour[l]];
        const int I = p < q ? p : q, J = p < q ? q : p;
        double D[3];

        bundle[l] = -1;
        if (I == J) continue;
        if (I != current) first = big->n_links;
        current = I;
        between_centroids(g, parent, offset, l, D);

        const int b = find_bundle(big, first, I, J, D);

        bundle[l] = b;
        big->strength[b] +=
            g->strength[l] * graph_length(g, l) / graph_length(big, b);
        big->strong[b] |= g->strong[l];
    }
    free(order);
}

struct graph *graph_aggregated(const struct graph *g, const int *root,
                               double *offset, int *parent, int *bundle)
{
    const int count = graph_number(g->n, root, parent);
    struct graph *const big = allocate(count, g->n_links);

    centre(g, parent, big, offset);
    bundle_links(g, parent, offset, big, bundle);
    return big;
}

/* --- pairwise aggregation
 */

/* A link is strong if its S/d is at least this fraction of the largest of
 * either of its cells [-]. */
static const double strong_fraction = 0.4;

/* The axis (0, 1, 2) to which the link is closest; where only rounding tells
 * two axes apart, the first of them. */
static int graph_axis_of(const struct graph *g, int l)
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
        if (!g->strong[l] || graph_axis_of(g, l) != axis) continue;
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
    owner_free(A);
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

struct graph *graph_coarsened(struct graph *g, int *parent, int *bundle)
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
        owner_free(before);
    }
    free(p);
    free(b);
    return big;
}
