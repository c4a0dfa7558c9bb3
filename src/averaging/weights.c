/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights are computed at every use, unless the rule asks for caching:
 * computing those of a kernel for about 100 neighbours takes no longer than
 * reading them.
 *
 * For results that do not depend on the number of threads, the cells are
 * divided into fixed ranges. The particles of a range are summed in a separate
 * window of cells, and each cell then sums the windows that contain it, in
 * order.
 */
#include "averaging/weights.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

enum {
    WEIGHTS_STRIPS = 16, /* more windows would take longer to add up */
    WORTH_A_THREAD =
        128 /* particles; fewer take less time than starting another thread */
};

struct cell_range {
    int first, last; /* [-] cells first .. last - 1 */
    int low, high;   /* [-] window: cells low .. high - 1 */
    double *sum;     /* window of sums, side by side */
    double *weight;  /* [-] of one particle */
};

/* Weights that are not 0, particle after particle as their cells have them.
 * Particle member[a] has those from start[a] to start[a + 1]. */
struct kept {
    int *start;      /* [-] capacity + 1 */
    int *step;       /* [-] from the cell to the cell */
    double *w;       /* [-] */
    int capacity;    /* [-] of step and w */
    int unsupported; /* [-] particles assigned to their own cell alone */
    double *try;     /* [-] all weights of one particle */
};

struct weights {
    const struct cell_of_particle *h; /* borrowed */
    struct stencil *stencil;
    enum stencil_to to;
    double reach; /* [m] */
    int fields;   /* [-] most in a call */
    struct weights_rule rule;
    struct kept cached_weights;
    struct cell_range ranges[WEIGHTS_STRIPS];
};

struct neighbourhood weights_around(const struct weights *s, int c)
{
    const struct stencil *const near = s->stencil;
    const int first = near->start[near->shape[c]];
    const int n = near->start[near->shape[c] + 1] - first;
    return (struct neighbourhood){c,
                                  n,
                                  first,
                                  &near->step[first],
                                  &near->dx[first],
                                  &near->dy[first],
                                  &near->dz[first]};
}

/* The weights of one particle and the cells that they belong to. */
struct weight_list {
    int n;
    const int *step;
    const double *w;
};

enum way { SPREAD, GATHER };

/* Spread: adds the weighted amounts `from` of one particle to the cells around
 * its cell, whose sums begin at `to`. Gather: `to` the particle is the weighted
 * sum of the fields around the cell, which begin at `from`. */
static inline void find_weights_of(enum way way, int m,
                                   const struct weight_list *l,
                                   const double *restrict from,
                                   double *restrict to)
{
    if (way == SPREAD) {
        for (int e = 0; e < l->n; e++)
#pragma omp simd
            for (int j = 0; j < m; j++)
                to[m * l->step[e] + j] += l->w[e] * from[j];
        return;
    }
    for (int j = 0; j < m; j++)
        to[j] = 0.0;
    for (int e = 0; e < l->n; e++)
        for (int j = 0; j < m; j++)
            to[j] += l->w[e] * from[m * l->step[e] + j];
}

/* Loops of known length for the frequent numbers of fields: up to twice as
 * fast. */
static void find_weights(enum way way, int m, const struct weight_list *l,
                         const double *from, double *to)
{
    switch (m) {
    case 3:
        find_weights_of(way, 3, l, from, to);
        break;
    case 4:
        find_weights_of(way, 4, l, from, to);
        break;
    case 7:
        find_weights_of(way, 7, l, from, to);
        break;
    case 8:
        find_weights_of(way, 8, l, from, to);
        break;
    default:
        find_weights_of(way, m, l, from, to);
    }
}

/* Writes the weights of particle i, and returns on how many of the entries they
 * are. Counts those assigned to their own cell alone. */
static int weigh(const struct weights *s, int i,
                 const struct neighbourhood *near, double *w, int *alone)
{
    if (s->rule.weigh(s->rule.state, i, near, w)) return near->n;
    w[0] = 1.0;
    ++*alone;
    return 1;
}

/* The weights of member a, cached or computed now. */
static struct weight_list list_of(const struct weights *s,
                                  const struct cell_range *t, int a,
                                  const struct neighbourhood *near, int *alone)
{
    const struct kept *const k = &s->cached_weights;

    if (s->rule.cache)
        return (struct weight_list){k->start[a + 1] - k->start[a],
                                    &k->step[k->start[a]], &k->w[k->start[a]]};
    const int n = weigh(s, s->h->particle[a], near, t->weight, alone);
    return (struct weight_list){n, near->index_offset, t->weight};
}

/* Spreads the particles whose cells are in the range into its window. Returns
 * how many have one cell only. */
static int spread_range(const struct weights *s, const struct cell_range *t,
                        int m, const double *q)
{
    const struct cell_of_particle *const h = s->h;
    int alone = 0;

    for (int e = 0; e < m * (t->high - t->low); e++)
        t->sum[e] = 0.0;
    for (int c = t->first; c < t->last; c++) {
        const struct neighbourhood near = weights_around(s, c);
        double *const host = &t->sum[m * (c - t->low)];
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const struct weight_list l = list_of(s, t, a, &near, &alone);
            find_weights(SPREAD, m, &l, &q[m * h->particle[a]], host);
        }
    }
    return alone;
}

static void gather_range(const struct weights *s, const struct cell_range *t,
                         int m, const double *field, double *q)
{
    const struct cell_of_particle *const h = s->h;
    int alone = 0; /* not cached */

    for (int c = t->first; c < t->last; c++) {
        const struct neighbourhood near = weights_around(s, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const struct weight_list l = list_of(s, t, a, &near, &alone);
            find_weights(GATHER, m, &l, &field[m * c], &q[m * h->particle[a]]);
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
    for (int k = 0; k < WEIGHTS_STRIPS; k++) {
        const struct cell_range *const t = &s->ranges[k];
        if (c < t->low || c >= t->high || is_empty(s, t)) continue;
        for (int j = 0; j < m; j++)
            f[j] += t->sum[m * (c - t->low) + j];
    }
    for (int j = 0; j < m; j++)
        f[j] /= s->h->mesh->V[c]; /* [XS11 3.5a, 3.7, 3.8] */
}

int weights_spread(const struct weights *s, int m, const double *q,
                   double *field)
{
    const int n_cells = s->h->mesh->n_cells;
    int alone = 0;

#pragma omp parallel for schedule(dynamic, 1) reduction(+ : alone)            \
    if (s->h->n > WORTH_A_THREAD)
    for (int t = 0; t < WEIGHTS_STRIPS; t++)
        if (!is_empty(s, &s->ranges[t]))
            alone += spread_range(s, &s->ranges[t], m, q);
#pragma omp parallel for schedule(static) if (s->h->n > WORTH_A_THREAD)
    for (int c = 0; c < n_cells; c++)
        sum_windows(s, c, m, &field[m * c]);
    return s->rule.cache ? s->cached_weights.unsupported : alone;
}

void weights_gather(const struct weights *s, int m, const double *field,
                    double *q)
{
#pragma omp parallel for schedule(dynamic, 1) if (s->h->n > WORTH_A_THREAD)
    for (int t = 0; t < WEIGHTS_STRIPS; t++)
        gather_range(s, &s->ranges[t], m, field, q);
}

/* Range k of the cells, with the window of cells that its stencils reach. */
static void set_range(struct weights *s, int k)
{
    struct cell_range *const t = &s->ranges[k];
    const long long n = s->h->mesh->n_cells;

    t->first = (int)(n * k / WEIGHTS_STRIPS);
    t->last = (int)(n * (k + 1) / WEIGHTS_STRIPS);
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

/* Finds the cells that are near within the reach. */
static void find_neighbourhoods(struct weights *s)
{
    s->stencil = stencil_create(s->h->mesh, s->reach, s->to);
    for (int k = 0; k < WEIGHTS_STRIPS; k++)
        set_range(s, k);
    if (s->rule.cache)
        s->cached_weights.try = alloc_doubles(s->stencil->largest);
}

static void free_neighbourhoods(struct weights *s)
{
    for (int k = 0; k < WEIGHTS_STRIPS; k++) {
        free(s->ranges[k].sum);
        free(s->ranges[k].weight);
    }
    free(s->cached_weights.try);
    stencil_free(s->stencil);
}

struct weights *weights_create(const struct cell_of_particle *h, double reach,
                               enum stencil_to to, int fields,
                               struct weights_rule rule)
{
    struct weights *const s = alloc_zeroed(1, sizeof *s);

    s->h = h;
    s->to = to;
    s->reach = reach;
    s->fields = fields;
    s->rule = rule;
    if (rule.cache) s->cached_weights.start = alloc_ints(h->ps->capacity + 1);
    find_neighbourhoods(s);
    return s;
}

void weights_extend(struct weights *s, double reach)
{
    if (reach <= s->reach) return;
    free_neighbourhoods(s);
    s->reach = reach;
    find_neighbourhoods(s);
}

/* Makes room for n more weights after the first `used`. */
static void make_room(struct kept *k, int used, int n)
{
    if (used + n <= k->capacity) return;
    const int room = 2 * (used + n);
    int *const step = alloc_ints(room);
    double *const w = alloc_doubles(room);

    if (used > 0) memcpy(step, k->step, (size_t)used * sizeof *step);
    if (used > 0) memcpy(w, k->w, (size_t)used * sizeof *w);
    free(k->step);
    free(k->w);
    k->step = step;
    k->w = w;
    k->capacity = room;
}

void weights_bind(struct weights *s)
{
    const struct cell_of_particle *const h = s->h;
    struct kept *const k = &s->cached_weights;
    int used = 0;

    k->unsupported = 0;
    for (int c = 0; c < h->mesh->n_cells; c++) {
        const struct neighbourhood near = weights_around(s, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const int n =
                weigh(s, h->particle[a], &near, k->try, &k->unsupported);
            make_room(k, used, n);
            k->start[a] = used;
            for (int e = 0; e < n; e++) {
                if (k->try[e] == 0.0) continue;
                k->step[used] = near.index_offset[e];
                k->w[used++] = k->try[e];
            }
        }
    }
    k->start[h->n] = used;
}

const struct stencil *weights_stencil(const struct weights *s)
{
    return s->stencil;
}

void weights_free(struct weights *s)
{
    if (s == NULL) return;
    free_neighbourhoods(s);
    free(s->cached_weights.start);
    free(s->cached_weights.step);
    free(s->cached_weights.w);
    free(s);
}
