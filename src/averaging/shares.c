/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights are computed anew at every use, unless the rule says otherwise: those
 * of a kernel on a cell's ~100 neighbours are as cheap as to read them.
 *
 * To be independent of the number of threads, the hosts are cut into strips
 * that never change. A strip adds up its particles in a window of cells of its
 * own, and each cell then adds the windows it lies in, in their order.
 */
#include "averaging/shares.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

enum {
    SHARES_STRIPS = 16,  /* more windows would take longer to add up */
    WORTH_A_THREAD = 128 /* particles; fewer are done before it wakes up */
};

struct strip {
    int first, last; /* [-] hosts first .. last - 1 */
    int low, high;   /* [-] window: cells low .. high - 1 */
    double *sum;     /* window of sums, side by side */
    double *weight;  /* [-] of one particle */
};

/* Weights that are not 0, particle after particle as their hosts have them.
 * Particle member[a] has those from start[a] to start[a + 1]. */
struct kept {
    int *start;  /* [-] capacity + 1 */
    int *step;   /* [-] from the host to the cell */
    double *w;   /* [-] */
    int room;    /* [-] of step and w */
    int alone;   /* [-] particles that went to their host alone */
    double *try; /* [-] all weights of one particle */
};

struct shares {
    const struct hosts *h; /* borrowed */
    struct stencil *near;
    enum stencil_to to;
    double reach; /* [m] */
    int fields;   /* [-] most in a call */
    struct shares_rule rule;
    struct kept kept;
    struct strip strip[SHARES_STRIPS];
};

struct around shares_around(const struct shares *s, int c)
{
    const struct stencil *const near = s->near;
    const int first = near->start[near->shape[c]];
    const int n = near->start[near->shape[c] + 1] - first;
    return (struct around){c,
                           n,
                           first,
                           &near->step[first],
                           &near->dx[first],
                           &near->dy[first],
                           &near->dz[first]};
}

/* The weights of one particle and where they go. */
struct list {
    int n;
    const int *step;
    const double *w;
};

enum way { SPREAD, GATHER };

/* Spread: adds the weighted amounts `from` of one particle to the cells around
 * its host, whose sums begin at `to`. Gather: `to` the particle is the weighted
 * sum of the fields around the host, which begin at `from`. */
static inline void share_loop(enum way way, int m, const struct list *l,
                              const double *restrict from, double *restrict to)
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
static void share_one(enum way way, int m, const struct list *l,
                      const double *from, double *to)
{
    switch (m) {
    case 3:
        share_loop(way, 3, l, from, to);
        break;
    case 4:
        share_loop(way, 4, l, from, to);
        break;
    case 7:
        share_loop(way, 7, l, from, to);
        break;
    case 8:
        share_loop(way, 8, l, from, to);
        break;
    default:
        share_loop(way, m, l, from, to);
    }
}

/* Writes the weights of particle i, and returns on how many of the entries
 * they are. Counts those that went to their host alone. */
static int weigh(const struct shares *s, int i, const struct around *near,
                 double *w, int *alone)
{
    if (s->rule.weigh(s->rule.state, i, near, w)) return near->n;
    w[0] = 1.0;
    ++*alone;
    return 1;
}

/* Of place a of the members, either kept or found now. */
static struct list list_of(const struct shares *s, const struct strip *t, int a,
                           const struct around *near, int *alone)
{
    const struct kept *const k = &s->kept;

    if (s->rule.keep)
        return (struct list){k->start[a + 1] - k->start[a],
                             &k->step[k->start[a]], &k->w[k->start[a]]};
    const int n = weigh(s, s->h->member[a], near, t->weight, alone);
    return (struct list){n, near->step, t->weight};
}

/* Spreads the particles whose hosts are in the strip into its window. Returns
 * how many have one cell only. */
static int spread_strip(const struct shares *s, const struct strip *t, int m,
                        const double *q)
{
    const struct hosts *const h = s->h;
    int alone = 0;

    for (int e = 0; e < m * (t->high - t->low); e++)
        t->sum[e] = 0.0;
    for (int c = t->first; c < t->last; c++) {
        const struct around near = shares_around(s, c);
        double *const host = &t->sum[m * (c - t->low)];
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const struct list l = list_of(s, t, a, &near, &alone);
            share_one(SPREAD, m, &l, &q[m * h->member[a]], host);
        }
    }
    return alone;
}

static void gather_strip(const struct shares *s, const struct strip *t, int m,
                         const double *field, double *q)
{
    const struct hosts *const h = s->h;
    int alone = 0; /* not asked for */

    for (int c = t->first; c < t->last; c++) {
        const struct around near = shares_around(s, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const struct list l = list_of(s, t, a, &near, &alone);
            share_one(GATHER, m, &l, &field[m * c], &q[m * h->member[a]]);
        }
    }
}

static int is_empty(const struct shares *s, const struct strip *t)
{
    return s->h->start[t->first] == s->h->start[t->last];
}

/* Adds up the windows that cell c lies in. */
static void sum_windows(const struct shares *s, int c, int m, double *f)
{
    for (int j = 0; j < m; j++)
        f[j] = 0.0;
    for (int k = 0; k < SHARES_STRIPS; k++) {
        const struct strip *const t = &s->strip[k];
        if (c < t->low || c >= t->high || is_empty(s, t)) continue;
        for (int j = 0; j < m; j++)
            f[j] += t->sum[m * (c - t->low) + j];
    }
    for (int j = 0; j < m; j++)
        f[j] /= s->h->mesh->V[c]; /* [XS11 3.5a, 3.7, 3.8] */
}

int shares_spread(const struct shares *s, int m, const double *q, double *field)
{
    const int n_cells = s->h->mesh->n_cells;
    int alone = 0;

#pragma omp parallel for schedule(dynamic, 1) reduction(+ : alone)            \
    if (s->h->n > WORTH_A_THREAD)
    for (int t = 0; t < SHARES_STRIPS; t++)
        if (!is_empty(s, &s->strip[t]))
            alone += spread_strip(s, &s->strip[t], m, q);
#pragma omp parallel for schedule(static) if (s->h->n > WORTH_A_THREAD)
    for (int c = 0; c < n_cells; c++)
        sum_windows(s, c, m, &field[m * c]);
    return s->rule.keep ? s->kept.alone : alone;
}

void shares_gather(const struct shares *s, int m, const double *field,
                   double *q)
{
#pragma omp parallel for schedule(dynamic, 1) if (s->h->n > WORTH_A_THREAD)
    for (int t = 0; t < SHARES_STRIPS; t++)
        gather_strip(s, &s->strip[t], m, field, q);
}

/* Strip k of the hosts, with the window that its stencils reach. */
static void cut_strip(struct shares *s, int k)
{
    struct strip *const t = &s->strip[k];
    const long long n = s->h->mesh->n_cells;

    t->first = (int)(n * k / SHARES_STRIPS);
    t->last = (int)(n * (k + 1) / SHARES_STRIPS);
    t->low = t->first;
    t->high = t->last;
    for (int c = t->first; c < t->last; c++) {
        const struct around near = shares_around(s, c);
        for (int e = 0; e < near.n; e++) {
            if (c + near.step[e] < t->low) t->low = c + near.step[e];
            if (c + near.step[e] >= t->high) t->high = c + near.step[e] + 1;
        }
    }
    t->sum = alloc_doubles(s->fields * (t->high - t->low));
    t->weight = alloc_doubles(s->near->largest);
}

/* Finds the cells that are near within the reach. */
static void look_around(struct shares *s)
{
    s->near = stencil_create(s->h->mesh, s->reach, s->to);
    for (int k = 0; k < SHARES_STRIPS; k++)
        cut_strip(s, k);
    if (s->rule.keep) s->kept.try = alloc_doubles(s->near->largest);
}

static void forget_around(struct shares *s)
{
    for (int k = 0; k < SHARES_STRIPS; k++) {
        free(s->strip[k].sum);
        free(s->strip[k].weight);
    }
    free(s->kept.try);
    stencil_free(s->near);
}

struct shares *shares_create(const struct hosts *h, double reach,
                             enum stencil_to to, int fields,
                             struct shares_rule rule)
{
    struct shares *const s = alloc_zeroed(1, sizeof *s);

    s->h = h;
    s->to = to;
    s->reach = reach;
    s->fields = fields;
    s->rule = rule;
    if (rule.keep) s->kept.start = alloc_ints(h->ps->capacity + 1);
    look_around(s);
    return s;
}

void shares_extend(struct shares *s, double reach)
{
    if (reach <= s->reach) return;
    forget_around(s);
    s->reach = reach;
    look_around(s);
}

/* Room for n weights more after the first `used`. */
static void make_room(struct kept *k, int used, int n)
{
    if (used + n <= k->room) return;
    const int room = 2 * (used + n);
    int *const step = alloc_ints(room);
    double *const w = alloc_doubles(room);

    if (used > 0) memcpy(step, k->step, (size_t)used * sizeof *step);
    if (used > 0) memcpy(w, k->w, (size_t)used * sizeof *w);
    free(k->step);
    free(k->w);
    k->step = step;
    k->w = w;
    k->room = room;
}

void shares_bind(struct shares *s)
{
    const struct hosts *const h = s->h;
    struct kept *const k = &s->kept;
    int used = 0;

    k->alone = 0;
    for (int c = 0; c < h->mesh->n_cells; c++) {
        const struct around near = shares_around(s, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const int n = weigh(s, h->member[a], &near, k->try, &k->alone);
            make_room(k, used, n);
            k->start[a] = used;
            for (int e = 0; e < n; e++) {
                if (k->try[e] == 0.0) continue;
                k->step[used] = near.step[e];
                k->w[used++] = k->try[e];
            }
        }
    }
    k->start[h->n] = used;
}

const struct stencil *shares_stencil(const struct shares *s)
{
    return s->near;
}

void shares_free(struct shares *s)
{
    if (s == NULL) return;
    forget_around(s);
    free(s->kept.start);
    free(s->kept.step);
    free(s->kept.w);
    free(s);
}
