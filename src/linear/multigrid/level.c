/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/level.h"

#include "base/alloc.h"
#include "base/parallel_ranges.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct level_members members_of(int n_groups, int n, const int *group)
{
    struct level_members m = {alloc_ints(n_groups + 1), NULL, NULL};
    int *const next = alloc_ints(n_groups + 1);

    for (int i = 0; i < n; i++)
        if (group[i] >= 0) m.start[group[i] + 1]++;
    for (int s = 0; s < n_groups; s++)
        m.start[s + 1] += m.start[s];
    for (int s = 0; s < n_groups; s++)
        next[s] = m.start[s];
    m.list = alloc_ints(m.start[n_groups]);
    m.weight = alloc_doubles(m.start[n_groups]);
    for (int i = 0; i < n; i++)
        if (group[i] >= 0) m.list[next[group[i]]++] = i;
    free(next);
    return m;
}

static void members_release(struct level_members *m)
{
    free(m->start);
    free(m->list);
    free(m->weight);
}

static float *alloc_floats(int n)
{
    return alloc_zeroed((size_t)n, sizeof(float));
}

void level_init(struct level *v, const struct graph *g, int finest)
{
    v->n = g->n;
    v->n_links = g->n_links;
    v->kind = &level_matrix_bands;
    v->A = v->kind->create(g->n, g->n_links, g->owner, g->neighbour, finest);
    v->g = alloc_doubles(g->n_links);
    v->sums = alloc_doubles(g->n);
    v->b = alloc_floats(g->n);
    v->r = alloc_floats(g->n);
    v->x = v->kind->vector(v->A);
    v->y = v->kind->vector(v->A);
}

void level_release(struct level *v)
{
    v->kind->vector_free(v->A, v->x);
    v->kind->vector_free(v->A, v->y);
    v->kind->free(v->A);
    free(v->g);
    free(v->sums);
    free(v->b);
    free(v->r);
    free(v->parent);
    members_release(&v->links);
    members_release(&v->cells);
}

/* The factor of the coefficient between cell i and a wall on the coarser level,
 * where the distance from the wall is that of the aggregate I [-]. */
static double wall_factor(const struct graph *fine, int i,
                          const struct graph *coarse, int I)
{
    const double depth = graph_depth(fine, i);

    return depth > 0.0 ? fmin(1.0, depth / graph_depth(coarse, I)) : 1.0;
}

void level_connect(struct level *v, const struct graph *fine,
                   const struct graph *coarse, const int *parent,
                   const int *bundle)
{
    struct level_members *const links = &v->links, *const cells = &v->cells;

    *links = members_of(coarse->n_links, fine->n_links, bundle);
    for (int L = 0; L < coarse->n_links; L++)
        for (int s = links->start[L]; s < links->start[L + 1]; s++)
            links->weight[s] = fmin(1.0, graph_length(fine, links->list[s]) /
                                             graph_length(coarse, L));
    *cells = members_of(coarse->n, fine->n, parent);
    for (int I = 0; I < coarse->n; I++)
        for (int s = cells->start[I]; s < cells->start[I + 1]; s++)
            cells->weight[s] = wall_factor(fine, cells->list[s], coarse, I);
}

void level_set_fine(struct level *v, const double *g, const double *sums,
                    double unit)
{
    memcpy(v->g, g, (size_t)v->n_links * sizeof *g);
    memcpy(v->sums, sums, (size_t)v->n * sizeof *sums);
    v->kind->fill(v->A, v->g, v->sums, unit);
}

/* coarse[i] = the weighted sum of the members of i among the fine. */
static void level_gather(int first, int last, const struct level_members *m,
                         const double *fine, double *coarse)
{
    for (int i = first; i < last; i++) {
        double sum = 0.0;

        for (int s = m->start[i]; s < m->start[i + 1]; s++)
            sum += m->weight[s] * fine[m->list[s]];
        coarse[i] = sum;
    }
}

void level_galerkin_coarsen(struct level *v, const struct level *fine,
                            double unit)
{
    PARALLEL_RANGES(v->n_links, 8, level_gather, &v->links, fine->g, v->g);
    PARALLEL_RANGES(v->n, 8, level_gather, &v->cells, fine->sums, v->sums);
    v->kind->fill(v->A, v->g, v->sums, unit);
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

void level_restrict(struct level *v, const struct level *fine)
{
    PARALLEL_RANGES(v->n, 8, restrict_rows, v, fine->r);
}

static void prolong_rows(int first, int last, struct level *fine,
                         const float *y)
{
    for (int i = first; i < last; i++)
        fine->y[i] += y[fine->parent[i]];
}

void level_prolong(const struct level *v, struct level *fine)
{
    PARALLEL_RANGES(fine->n, 1, prolong_rows, fine, v->y);
}
