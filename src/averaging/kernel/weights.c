/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights are computed at every use, unless the rule has a list of them:
 * computing those of a kernel for about 100 neighbours takes no longer than
 * reading them.
 *
 * For results that do not depend on the number of threads, the cells are
 * divided into fixed ranges. The particles of a range are summed in a separate
 * window of cells, and each cell then sums the windows that contain it, in
 * order. */
#include "averaging/kernel/weights.h"

#include <stdlib.h>

#include "averaging/averaging.h"
#include "base/alloc.h"

enum { RANGES = 16 }; /* [-] more windows would take longer to add up */

/* [-] particles; fewer take less time than starting another thread */
enum { MIN_PARALLEL_NUMBERS = 128 };

struct cell_range {
    int first, last; /* [-] cells first .. last - 1 */
    int low, high;   /* [-] window: cells low .. high - 1 */
    double *sum;     /* window of sums, side by side */
    double *weight;  /* [-] of one particle */
};

struct weights {
    const struct cell_of_particle *h; /* borrowed */
    struct stencil *stencil;
    struct weights_rule rule;
    enum stencil_to to;
    int fields; /* [-] most in a call */
    struct cell_range ranges[RANGES];
};

void *weights_state(const struct weights *s)
{
    return s->rule.state;
}

struct neighbourhood weights_around(const struct weights *s, int c)
{
    const struct stencil *const near = s->stencil;
    const int first = near->start[near->shape[c]];
    const int n = near->start[near->shape[c] + 1] - first;
    return (struct neighbourhood){c,
                                  n,
                                  &near->index_offset[first],
                                  &near->dx[first],
                                  &near->dy[first],
                                  &near->dz[first]};
}

enum way { SPREAD, GATHER };

/* Spread: adds the weighted amounts `from` of one particle to the cells around
 * its cell, whose sums begin at `to`. Gather: `to` the particle is the weighted
 * sum of the fields around the cell, which begin at `from`. */
static inline void apply_weights_of(enum way way, int m,
                                    const struct weight_list *l,
                                    const double *restrict from,
                                    double *restrict to)
{
    if (way == SPREAD) {
        for (int e = 0; e < l->n; e++)
#pragma omp simd
            for (int j = 0; j < m; j++)
                to[m * l->index_offset[e] + j] += l->w[e] * from[j];
        return;
    }
    for (int j = 0; j < m; j++)
        to[j] = 0.0;
    for (int e = 0; e < l->n; e++)
        for (int j = 0; j < m; j++)
            to[j] += l->w[e] * from[m * l->index_offset[e] + j];
}

/* Loops of known length for the frequent numbers of fields: up to twice as
 * fast. */
static void apply_weights(enum way way, int m, const struct weight_list *l,
                          const double *from, double *to)
{
    switch (m) {
    case 3:
        apply_weights_of(way, 3, l, from, to);
        break;
    case 4:
        apply_weights_of(way, 4, l, from, to);
        break;
    case 7:
        apply_weights_of(way, 7, l, from, to);
        break;
    case 8:
        apply_weights_of(way, 8, l, from, to);
        break;
    default:
        apply_weights_of(way, m, l, from, to);
    }
}

/* The weights of particle a of the sorted ones, computed now unless the rule
 * has a list of them. A particle without any weight is assigned to its own cell
 * and counted. */
static struct weight_list weights_list_of(const struct weights *s,
                                          const struct cell_range *t, int a,
                                          const struct neighbourhood *near,
                                          int *unsupported)
{
    const struct weights_rule *const rule = &s->rule;
    int n = near->n;

    if (rule->list != NULL) return rule->list(rule->state, a);
    if (!rule->weigh(rule->state, s->h->particle[a], near, t->weight)) {
        t->weight[0] = n = 1;
        ++*unsupported;
    }
    return (struct weight_list){n, near->index_offset, t->weight};
}

/* Spreads the particles whose cells are in the range into its window. Returns
 * the number of those that were assigned to their own cell alone. */
static int spread_range(const struct weights *s, const struct cell_range *t,
                        int m, const double *q)
{
    const struct cell_of_particle *const h = s->h;
    int unsupported = 0;

    for (int e = 0; e < m * (t->high - t->low); e++)
        t->sum[e] = 0.0;
    for (int c = t->first; c < t->last; c++) {
        const struct neighbourhood near = weights_around(s, c);
        double *const own = &t->sum[m * (c - t->low)];
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const struct weight_list l =
                weights_list_of(s, t, a, &near, &unsupported);
            apply_weights(SPREAD, m, &l, &q[m * h->particle[a]], own);
        }
    }
    return unsupported;
}

static void gather_range(const struct weights *s, const struct cell_range *t,
                         int m, const double *field, double *q)
{
    const struct cell_of_particle *const h = s->h;
    int unsupported = 0; /* not reported */

    for (int c = t->first; c < t->last; c++) {
        const struct neighbourhood near = weights_around(s, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const struct weight_list l =
                weights_list_of(s, t, a, &near, &unsupported);
            apply_weights(GATHER, m, &l, &field[m * c], &q[m * h->particle[a]]);
        }
    }
}

static int is_empty(const struct weights *s, const struct cell_range *t)
{
    return s->h->start[t->first] == s->h->start[t->last];
}

/* Adds up the windows that cell c lies in. */
static void sum_windows(const struct weights *s, int c, int m, double *f)
{
    for (int j = 0; j < m; j++)
        f[j] = 0.0;
    for (int k = 0; k < RANGES; k++) {
        const struct cell_range *const t = &s->ranges[k];
        if (c < t->low || c >= t->high || is_empty(s, t)) continue;
        for (int j = 0; j < m; j++)
            f[j] += t->sum[m * (c - t->low) + j];
    }
    for (int j = 0; j < m; j++)
        f[j] /= s->h->mesh->V[c]; /* [XS11 3.5a, 3.7, 3.8] */
}

void weights_spread(void *weights, int m, const double *q, double *field,
                    struct averaging_report *r)
{
    const struct weights *const s = weights;
    const int n_cells = s->h->mesh->n_cells;
    int unsupported = 0;

#pragma omp parallel for schedule(dynamic, 1) reduction(+ : unsupported)            \
    if (s->h->n > MIN_PARALLEL_NUMBERS)
    for (int t = 0; t < RANGES; t++)
        if (!is_empty(s, &s->ranges[t]))
            unsupported += spread_range(s, &s->ranges[t], m, q);
#pragma omp parallel for schedule(static) if (s->h->n > MIN_PARALLEL_NUMBERS)
    for (int c = 0; c < n_cells; c++)
        sum_windows(s, c, m, &field[m * c]);
    if (s->rule.list == NULL) r->unsupported = unsupported;
}

void weights_gather(void *weights, int m, const double *field, double *q,
                    struct averaging_report *r)
{
    const struct weights *const s = weights;

    (void)r;
#pragma omp parallel for schedule(dynamic,                                     \
                                  1) if (s->h->n > MIN_PARALLEL_NUMBERS)
    for (int t = 0; t < RANGES; t++)
        gather_range(s, &s->ranges[t], m, field, q);
}

/* Range k of the cells, with the window of cells that its stencils reach. */
static void set_range(struct weights *s, int k)
{
    struct cell_range *const t = &s->ranges[k];
    const long long n = s->h->mesh->n_cells;

    t->first = (int)(n * k / RANGES);
    t->last = (int)(n * (k + 1) / RANGES);
    t->low = t->first;
    t->high = t->last;
    for (int c = t->first; c < t->last; c++) {
        const struct neighbourhood near = weights_around(s, c);
        for (int e = 0; e < near.n; e++) {
            if (c + near.index_offset[e] < t->low)
                t->low = c + near.index_offset[e];
            if (c + near.index_offset[e] >= t->high)
                t->high = c + near.index_offset[e] + 1;
        }
    }
    t->sum = alloc_doubles(s->fields * (t->high - t->low));
    t->weight = alloc_doubles(s->stencil->largest);
}

static void weights_release_stencil(struct weights *s)
{
    for (int k = 0; k < RANGES; k++) {
        free(s->ranges[k].sum);
        free(s->ranges[k].weight);
    }
    stencil_free(s->stencil);
}

void weights_set_reach(struct weights *s, double reach)
{
    weights_release_stencil(s);
    s->stencil = stencil_create(s->h->mesh, reach, s->to);
    for (int k = 0; k < RANGES; k++)
        set_range(s, k);
}

struct weights *weights_create(const struct cell_of_particle *h, double reach,
                               enum stencil_to to, int fields,
                               struct weights_rule rule)
{
    struct weights *const s = alloc_zeroed(1, sizeof *s);

    s->h = h;
    s->rule = rule;
    s->to = to;
    s->fields = fields;
    weights_set_reach(s, reach);
    return s;
}

double weights_bytes(const struct averaging_method *method,
                     const struct mesh *mesh, double d,
                     const struct averaging_options *o)
{
    const struct averaging_method *const variant =
        averaging_variant(method, mesh);
    const double reach = variant->reach_b * o->bandwidth + variant->reach_d * d;
    const enum stencil_to to =
        variant->reach_d > 0.0 ? STENCIL_TO_CELL : STENCIL_TO_CENTRE;
    return reach > 0.0 ? stencil_bytes(mesh, reach, to) : 0.0;
}

const struct stencil *weights_stencil(const struct weights *s)
{
    return s->stencil;
}

void weights_free(void *weights)
{
    struct weights *const s = weights;

    weights_release_stencil(s);
    s->rule.free(s->rule.state);
    free(s);
}
