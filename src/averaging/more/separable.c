/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each direction is processed in bundles of WIDTH lines that are copied into
 * interleaved buffers: the same vectorised loop then works for all directions
 * and any number of fields, and memory is read and written once. */
#include "averaging/more/separable.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/more/bandwidth.h"
#include "base/alloc.h"
#include "linear/chebyshev.h"

enum {
    WIDTH = 16,       /* numbers side by side: two of the widest vectors */
    MOST_THREADS = 64 /* each has a bundle of its own */
};

/* Number of products in a direction above which a second thread is faster: 5
 * microseconds of one thread. */
static const long worth_a_thread = 100000;

/* Tolerance of the weights themselves. */
static const double exact = 1e-17; /* [-] */

/* The weights of one direction. Row i goes over the places i - reach .. i +
 * reach of a line that is continued by `reach` cells at either end: round the
 * period, or, at walls, by cells of weight zero. A row as long as the line goes
 * over places 0 .. n - 1. */
struct direction {
    int n, reach;
    int whole;    /* 1: rows are as long as the line */
    int length;   /* [-] of a row */
    int periodic; /* 1: ends are one */
    double *w;    /* [-] n rows */
};

struct separable {
    struct direction direction[3];
    double *bundle; /* a packed and continued bundle for each thread */
    long size;      /* [-] of one bundle */
};

/* exp(-T L) of the line, n by n: the series on each column of the identity.
 * w[n * i + j] is what i has of j. */
static double *all_weights(const struct box *box, int k, double T, double b)
{
    const int n = box->n[k], links = box->periodic[k] ? n : n - 1;
    const double *const edge = box->edge[k];
    int *const owner = alloc_ints(links), *const neighbour = alloc_ints(links);
    double *const dx = alloc_doubles(n), *const w = alloc_doubles(n * n);

    for (int i = 0; i < n; i++) {
        dx[i] = edge[i + 1] - edge[i];
        w[n * i + i] = 1.0;
    }
    for (int l = 0; l < links; l++) {
        owner[l] = l;
        neighbour[l] = (l + 1) % n;
    }
    struct csr *const K = csr_create(n, links, owner, neighbour);
    for (int l = 0; l < links; l++) {
        const int i = owner[l], j = neighbour[l];
        const double d = 0.5 * (dx[i] + dx[j]);
        const double D = b > 0.0 ? bandwidth_minus_cell(1.0, d, b) : 1.0;
        const double g = i == j ? 0.0 : D / d; /* [1/m] */
        K->a[K->upper[l]] = K->a[K->lower[l]] = -g;
        K->diag[i] += g;
        K->diag[j] += g;
    }
    struct chebyshev *const series = chebyshev_create(K, dx, T, exact, n);
    chebyshev_apply(series, n, w);
    owner_free(series);
    owner_free(K);
    free(owner);
    free(neighbour);
    free(dx);
    return w;
}

/* How far apart cells i and j of the line are, counted in cells. */
static int separable_apart(const struct direction *d, int i, int j)
{
    const int straight = abs(i - j);
    return d->periodic && d->n - straight < straight ? d->n - straight
                                                     : straight;
}

/* The weight of row i beyond the reach. */
static double separable_beyond(const struct direction *d, const double *all,
                               int i, int reach)
{
    double sum = 0.0;

    for (int j = 0; j < d->n; j++)
        if (separable_apart(d, i, j) > reach) sum += all[d->n * i + j];
    return sum;
}

/* The least reach, the same for all rows for the sake of symmetry, beyond which
 * no row has more than tail. */
static int find_reach(const struct direction *d, const double *all, double tail)
{
    int reach = 0;

    for (int i = 0; i < d->n; i++)
        while (separable_beyond(d, all, i, reach) > tail)
            reach++;
    return reach;
}

/* Writes the rows; dropped weights are added to the weight of the cell itself.
 */
static void store_weights(struct direction *d, const double *all)
{
    const int n = d->n;

    d->w = alloc_doubles(n * d->length);
    for (int i = 0; i < n; i++) {
        double *const row = &d->w[d->length * i];
        const int first = d->whole ? 0 : i - d->reach;
        for (int e = 0; e < d->length; e++) {
            const int j = first + e;
            if (!d->periodic && (j < 0 || j >= n)) continue;
            row[e] = fmax(0.0, all[n * i + (j + n) % n]); /* -1e-18 is 0 */
        }
        double others = 0.0;
        for (int e = 0; e < d->length; e++)
            if (first + e != i) others += row[e];
        row[i - first] = 1.0 - others;
    }
}

static void find_direction(struct direction *d, const struct box *box, int k,
                           double T, double b, double tail)
{
    d->n = box->n[k];
    d->periodic = box->periodic[k];
    if (d->n == 1) return;
    double *const all = all_weights(box, k, T, b);
    d->reach = find_reach(d, all, tail);
    d->whole = 2 * d->reach + 1 >= d->n;
    d->length = d->whole ? d->n : 2 * d->reach + 1;
    store_weights(d, all);
    free(all);
}

struct separable *separable_create(const struct box *box, double T, double b,
                                   double tail)
{
    for (int k = 0; k < 3; k++)
        if (box->n[k] < 1 || box->n[k] > SEPARABLE_MOST) return NULL;
    struct separable *const s = owner_create(sizeof *s);

    for (int k = 0; k < 3; k++) {
        struct direction *const d = &s->direction[k];
        /* a dropped weight counts twice: where it is missing, and on the
         * diagonal */
        find_direction(d, box, k, T, b, tail / 6.0);
        owner_take(s, d->w);
        const long places = d->n + (d->whole ? 0 : 2 * d->reach);
        if (WIDTH * places > s->size) s->size = WIDTH * places;
    }
    s->bundle =
        owner_zeroed(s, (size_t)(MOST_THREADS * s->size), sizeof(double));
    return s;
}

int separable_reach(const struct separable *s, int k)
{
    return s->direction[k].reach;
}

/* Lines of one direction in memory: `inner` of them begin at neighbouring
 * numbers, and so do their next places, `inner` numbers on; `outer` such groups
 * follow each other. */
struct lines {
    const struct direction *d;
    int inner, outer;
    int parts;  /* [-] bundles to a group, if a group fills one */
    int groups; /* [-] groups to a bundle, if not */
    double *u;
};

/* The lines of bundle b: `count` groups from number `at` on, of `width` lines
 * each. */
struct bundle {
    long at;
    int count, width;
};

static int fewer(int a, int b)
{
    return a < b ? a : b;
}

static struct bundle bundle_of(const struct lines *l, int b)
{
    const long group = (long)l->d->n * l->inner;

    if (l->groups > 1) {
        const int first = b * l->groups;
        return (struct bundle){first * group,
                               fewer(l->groups, l->outer - first), l->inner};
    }
    const int first = b % l->parts * WIDTH;
    return (struct bundle){b / l->parts * group + first, 1,
                           fewer(WIDTH, l->inner - first)};
}

static void separable_pack(const struct lines *l, const struct bundle *b,
                           double *to)
{
    for (int g = 0; g < b->count; g++) {
        const double *const from = l->u + b->at + (long)g * l->d->n * l->inner;
        for (int i = 0; i < l->d->n; i++)
            for (int k = 0; k < b->width; k++)
                to[WIDTH * i + g * b->width + k] = from[(long)l->inner * i + k];
    }
}

/* Continues a packed bundle at both ends. At walls the weights are zero, and
 * so are the numbers. */
static void continue_lines(const struct direction *d, double *line)
{
    const size_t bytes = WIDTH * sizeof *line;

    for (int i = 0; i < d->reach; i++) {
        double *const below = line - (long)WIDTH * (i + 1);
        double *const above = line + (long)WIDTH * (d->n + i);
        if (d->periodic) {
            memcpy(below, line + (long)WIDTH * (d->n - 1 - i), bytes);
            memcpy(above, line + (long)WIDTH * i, bytes);
        } else {
            memset(below, 0, bytes);
            memset(above, 0, bytes);
        }
    }
}

/* sum = the weighted sum of n places: four at a time, so that the sums are read
 * and written less often (half the time). */
static inline void weighted(int n, const double *restrict w,
                            const double *restrict x, double *restrict sum)
{
    enum { W = WIDTH };
    double s[W];
    int e = 0;

    for (int k = 0; k < W; k++)
        s[k] = 0.0;
    for (; e + 4 <= n; e += 4) {
        const double *restrict const at = x + W * e;
        for (int k = 0; k < W; k++)
            s[k] += (w[e] * at[k] + w[e + 1] * at[W + k]) +
                    (w[e + 2] * at[2 * W + k] + w[e + 3] * at[3 * W + k]);
    }
    for (; e < n; e++)
        for (int k = 0; k < W; k++)
            s[k] += w[e] * x[W * e + k];
    for (int k = 0; k < W; k++)
        sum[k] = s[k];
}

static void apply_bundle(const struct lines *l, const struct bundle *b,
                         double *room)
{
    const struct direction *const d = l->d;
    double *const line = room + (d->whole ? 0 : (long)WIDTH * d->reach);

    separable_pack(l, b, line);
    if (!d->whole) continue_lines(d, line);
    for (int i = 0; i < d->n; i++) {
        double sum[WIDTH];
        double *const to = l->u + b->at + (long)l->inner * i;
        weighted(d->length, &d->w[d->length * i],
                 d->whole ? line : room + (long)WIDTH * i, sum);
        for (int g = 0; g < b->count; g++)
            for (int k = 0; k < b->width; k++)
                to[(long)g * d->n * l->inner + k] = sum[g * b->width + k];
    }
}

static void apply_bundles(const struct separable *s, const struct lines *l,
                          int all)
{
    const long work = (long)all * WIDTH * l->d->n * l->d->length;
    const int most = fewer(omp_get_max_threads(), MOST_THREADS);
    const int team = work > worth_a_thread ? most : 1;

#pragma omp parallel for schedule(static) num_threads(team)
    for (int i = 0; i < all; i++) {
        const struct bundle b = bundle_of(l, i);
        apply_bundle(l, &b, s->bundle + omp_get_thread_num() * s->size);
    }
}

static void apply_direction(struct separable *s, int k, int m, double *u)
{
    const struct direction *const d = &s->direction[k];
    struct lines l = {.d = d, .inner = m, .outer = 1, .u = u};

    for (int j = 0; j < 3; j++) {
        if (j < k) l.inner *= s->direction[j].n;
        if (j > k) l.outer *= s->direction[j].n;
    }
    l.groups = l.inner < WIDTH ? WIDTH / l.inner : 1;
    l.parts = (l.inner + WIDTH - 1) / WIDTH;
    const int all =
        l.groups > 1 ? (l.outer + l.groups - 1) / l.groups : l.outer * l.parts;
    apply_bundles(s, &l, all);
}

void separable_apply(struct separable *s, int m, double *u)
{
    for (int k = 0; k < 3; k++)
        if (s->direction[k].n > 1) apply_direction(s, k, m, u);
}
