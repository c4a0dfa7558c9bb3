/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights are computed anew at every use: on a cell's ~100 neighbours that is
 * as cheap as to read them from memory.
 *
 * To be independent of the number of threads, the hosts are cut into strips
 * that never change. A strip adds up its particles in a window of cells of its
 * own, and each cell then adds the windows it lies in, in their order.
 */
#include "averaging/kernel.h"

#include <stdio.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/hosts.h"
#include "averaging/stencil.h"
#include "base/alloc.h"

enum {
    KERNEL_STRIPS = 16,  /* more windows would take longer to add up */
    WORTH_A_THREAD = 128 /* particles; fewer are done before it wakes up */
};

struct strip {
    int first, last; /* [-] hosts first .. last - 1 */
    int low, high;   /* [-] window: cells low .. high - 1 */
    double *sum;     /* window of sums, side by side */
    double *weight;  /* [-] of one particle */
};

struct kernel {
    const struct hosts *h; /* borrowed */
    struct stencil *near;
    double b; /* [m] */
    struct strip strip[KERNEL_STRIPS];
};

/* [XS11 3.6] as a function of zeta^2. */
static inline double bell(double zeta2)
{
    const double one = zeta2 < 1.0 ? 1.0 - zeta2 : 0.0;
    return (one * one) * (one * one);
}

double kernel_bell(double zeta)
{
    return bell(zeta * zeta);
}

/* The weights of particle i over the stencil of its host, which begins at
 * entry `first` and has n: [XS11 3.5b]. They add up to one [XS11 3.4]. Returns
 * 1 if no centre is within b. */
static int find_weights(const struct kernel *k, int i, int first, int n,
                        double *restrict w)
{
    const double *const restrict dx = &k->near->dx[first];
    const double *const restrict dy = &k->near->dy[first];
    const double *const restrict dz = &k->near->dz[first];
    const double *const o = &k->h->offset[3 * i];
    const double x = o[0], y = o[1], z = o[2];
    const double per_b2 = 1.0 / (k->b * k->b);
    double sum = 0.0;

#pragma omp simd reduction(+ : sum)
    for (int e = 0; e < n; e++) {
        const double rx = dx[e] - x, ry = dy[e] - y, rz = dz[e] - z;
        w[e] = bell((rx * rx + ry * ry + rz * rz) * per_b2);
        sum += w[e];
    }
    if (!(sum > 0.0)) {
        w[0] = 1.0; /* the host; the others are zero already */
        return 1;
    }
    const double share = 1.0 / sum;
    for (int e = 0; e < n; e++)
        w[e] *= share;
    return 0;
}

/* The stencil of a host cell, as kept in k->near. */
struct around {
    int first, n;
    const int *step;
};

static struct around around_host(const struct kernel *k, int c)
{
    const struct stencil *const s = k->near;
    const int first = s->start[s->shape[c]];
    const int n = s->start[s->shape[c] + 1] - first;
    return (struct around){first, n, &s->step[first]};
}

/* Adds the weighted amounts q of one particle to the cells around its host,
 * whose sums begin at `host`. */
static inline void add_loop(int m, const struct around *near,
                            const double *restrict w, const double *restrict q,
                            double *host)
{
    for (int e = 0; e < near->n; e++) {
        double *restrict const to = &host[m * near->step[e]];
#pragma omp simd
        for (int j = 0; j < m; j++)
            to[j] += w[e] * q[j];
    }
}

/* q = the weighted sum of the fields around the host. */
static inline void take_loop(int m, const struct around *near,
                             const double *restrict w, const double *host,
                             double *restrict q)
{
    for (int j = 0; j < m; j++)
        q[j] = 0.0;
    for (int e = 0; e < near->n; e++)
        for (int j = 0; j < m; j++)
            q[j] += w[e] * host[m * near->step[e] + j];
}

/* Loops of known length for the frequent numbers of fields: up to twice as
 * fast. */
static void add_weighted(int m, const struct around *near, const double *w,
                         const double *q, double *host)
{
    switch (m) {
    case 3:
        add_loop(3, near, w, q, host);
        break;
    case 4:
        add_loop(4, near, w, q, host);
        break;
    case 8:
        add_loop(8, near, w, q, host);
        break;
    default:
        add_loop(m, near, w, q, host);
    }
}

static void take_weighted(int m, const struct around *near, const double *w,
                          const double *host, double *q)
{
    switch (m) {
    case 3:
        take_loop(3, near, w, host, q);
        break;
    case 4:
        take_loop(4, near, w, host, q);
        break;
    case 8:
        take_loop(8, near, w, host, q);
        break;
    default:
        take_loop(m, near, w, host, q);
    }
}

/* Spreads the particles whose hosts are in the strip into its window. Returns
 * how many had only their host. */
static int spread_strip(const struct kernel *k, const struct strip *s, int m,
                        const double *q)
{
    const struct hosts *const h = k->h;
    int alone = 0;

    for (int e = 0; e < m * (s->high - s->low); e++)
        s->sum[e] = 0.0;
    for (int c = s->first; c < s->last; c++) {
        const struct around near = around_host(k, c);
        double *const host = &s->sum[m * (c - s->low)];
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const int i = h->member[a];
            alone += find_weights(k, i, near.first, near.n, s->weight);
            add_weighted(m, &near, s->weight, &q[m * i], host);
        }
    }
    return alone;
}

static void gather_strip(const struct kernel *k, const struct strip *s, int m,
                         const double *field, double *q)
{
    const struct hosts *const h = k->h;

    for (int c = s->first; c < s->last; c++) {
        const struct around near = around_host(k, c);
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const int i = h->member[a];
            find_weights(k, i, near.first, near.n, s->weight);
            take_weighted(m, &near, s->weight, &field[m * c], &q[m * i]);
        }
    }
}

static int is_empty(const struct kernel *k, const struct strip *s)
{
    return k->h->start[s->first] == k->h->start[s->last];
}

static void kernel_spread(void *state, int m, const double *q, double *field,
                          struct averaging_report *r)
{
    const struct kernel *const k = state;
    const int n_cells = k->h->mesh->n_cells;
    int alone = 0;

#pragma omp parallel for schedule(dynamic, 1) reduction(+ : alone)            \
    if (k->h->n > WORTH_A_THREAD)
    for (int t = 0; t < KERNEL_STRIPS; t++)
        if (!is_empty(k, &k->strip[t]))
            alone += spread_strip(k, &k->strip[t], m, q);
    r->alone = alone;
#pragma omp parallel for schedule(static) if (k->h->n > WORTH_A_THREAD)
    for (int c = 0; c < n_cells; c++) {
        double *const f = &field[m * c];
        for (int j = 0; j < m; j++)
            f[j] = 0.0;
        for (int t = 0; t < KERNEL_STRIPS; t++) {
            const struct strip *const s = &k->strip[t];
            if (c < s->low || c >= s->high || is_empty(k, s)) continue;
            for (int j = 0; j < m; j++)
                f[j] += s->sum[m * (c - s->low) + j];
        }
        for (int j = 0; j < m; j++)
            f[j] /= k->h->mesh->V[c]; /* [XS11 3.5a, 3.7, 3.8] */
    }
}

static void kernel_gather(void *state, int m, const double *field, double *q,
                          struct averaging_report *r)
{
    const struct kernel *const k = state;

    (void)r;
#pragma omp parallel for schedule(dynamic, 1) if (k->h->n > WORTH_A_THREAD)
    for (int t = 0; t < KERNEL_STRIPS; t++)
        gather_strip(k, &k->strip[t], m, field, q);
}

/* Strip t of the hosts, with the window that its stencils reach. */
static void cut_strip(struct kernel *k, int t, int fields)
{
    struct strip *const s = &k->strip[t];
    const long long n = k->h->mesh->n_cells;

    s->first = (int)(n * t / KERNEL_STRIPS);
    s->last = (int)(n * (t + 1) / KERNEL_STRIPS);
    s->low = s->first;
    s->high = s->last;
    for (int c = s->first; c < s->last; c++) {
        const struct around near = around_host(k, c);
        for (int e = 0; e < near.n; e++) {
            if (c + near.step[e] < s->low) s->low = c + near.step[e];
            if (c + near.step[e] >= s->high) s->high = c + near.step[e] + 1;
        }
    }
    s->sum = alloc_doubles(fields * (s->high - s->low));
    s->weight = alloc_doubles(k->near->largest);
}

static void *kernel_create(const struct hosts *h,
                           const struct averaging_options *o)
{
    if (!(o->bandwidth > 0.0)) {
        fprintf(stderr,
                "winnow: the bandwidth of the kernel is %g; "
                "expected a length above 0 [m]\n",
                o->bandwidth);
        return NULL;
    }
    struct kernel *const k = alloc_zeroed(1, sizeof *k);

    k->h = h;
    k->b = o->bandwidth;
    k->near = stencil_create(h->mesh, k->b);
    for (int t = 0; t < KERNEL_STRIPS; t++)
        cut_strip(k, t, o->fields);
    return k;
}

static void kernel_free(void *state)
{
    struct kernel *const k = state;

    for (int t = 0; t < KERNEL_STRIPS; t++) {
        free(k->strip[t].sum);
        free(k->strip[t].weight);
    }
    stencil_free(k->near);
    free(k);
}

const struct averaging_method kernel_method = {
    .name = "kernel",
    .cite = "XS11 3.2-3.9",
    .what = "a bell-shaped weight on the cells around",
    .create = kernel_create,
    .free = kernel_free,
    .spread = kernel_spread,
    .gather = kernel_gather,
};
