/* SPDX-License-Identifier: GPL-3.0-or-later */
/* images.c -- a Gaussian around each particle, with mirror images behind the
 * walls.
 * Chapter "Further averaging methods".
 *
 *     W(r) = exp(-r^2 / 2 sigma^2) / (sigma sqrt(2 pi))^3            [EW18 19]
 *     sigma = delta_05 / (2 sqrt(2 ln 2)),  b = sqrt(2) sigma        [EW18 20]
 *     W_nw(x - x_i) = W(x - x_i) + W(x - x_image)                    [EW18 21]
 *     w_ic = integral of W_nw over cell c / that over all cells  [EW18 17, 18]
 *
 * delta_05 [m] is where W has half its height, as a width from side to side. b
 * is that of the diffusion [SX15 6]: this is the kernel that diffusion amounts
 * to, without a differential equation. The integrals are exact for cells of any
 * size; W is cut off at 3 b from the cell of the particle.
 *
 * EW18 normalise the sum (18) at each point of the mesh, which does not
 * conserve volume; here the weights of each particle sum to one.
 *
 * Only for boxes, whose walls are planes; there are images of images.
 */
/* In a box the Gaussian is a product of three.
 *
 * The weights of a particle in each slab of cells are computed once for each
 * direction in bind, images included; the weight of a cell is a product of
 * three numbers, and no neighbour search is needed. The cells are divided into
 * chunks of whole rows along x. For each chunk all particles are checked in
 * their order, so the sums are the same for any number of threads. */
#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "base/alloc.h"
#include "base/number.h"

static const double images_reach = 3.0; /* [-] of b, in each direction */
enum { CHUNKS = 16 };
enum { MOST_TURNS = 10000 }; /* the case allows no more */

struct images {
    const struct cell_of_particle *h; /* borrowed */
    double b;                         /* [m] */
    int wide;           /* [-] most slabs of a direction in reach */
    int *first, *count; /* [-] slabs in reach, 3 a particle; first may be
                           below 0 where it is periodic */
    double *share;      /* [-] `wide` a direction, 3 a particle */
};

double images_kernel(double r, double sigma)
{
    const double s = sigma * sqrt(2.0 * M_PI);
    return exp(-r * r / (2.0 * sigma * sigma)) / (s * s * s); /* [EW18 19] */
}

/* Edge j of direction k, continued across the period. */
static double edge(const struct box *b, int k, int j)
{
    const int n = b->n[k];
    const int turns = j >= 0 ? j / n : -((n - 1 - j) / n);
    const double L = b->edge[k][n] - b->edge[k][0];

    if (!b->periodic[k]) return b->edge[k][j];
    return b->edge[k][j - turns * n] + turns * L;
}

/* The integral of a Gaussian of width b up to z, minus 1/2. */
static double images_below(double z, double b)
{
    return z > 6.0 * b ? 0.5 : z < -6.0 * b ? -0.5 : 0.5 * erf(z / b);
}

/* The integral of the Gaussian around x and of all its images up to edge j, up
 * to a constant. Between two walls every second image is mirrored [EW18 21];
 * across a period none is. */
static double below_edge(const struct images *s, int k, int j, double x)
{
    const struct box *const b = &s->h->mesh->box;
    const double e = edge(b, k, j);
    const double wall = b->edge[k][0], L = b->edge[k][b->n[k]] - wall;
    const double step = b->periodic[k] ? L : 2.0 * L;
    const int turns =
        number_clamped(ceil((images_reach + 1.0) * s->b / step), 0, MOST_TURNS);
    double sum = 0.0;

    for (int t = -turns; t <= turns; t++) {
        sum += images_below(e - x - t * step, s->b);
        if (!b->periodic[k])
            sum += images_below(e - 2.0 * wall + x - t * step, s->b);
    }
    return sum;
}

/* The slabs of direction k that x, in slab `mine`, reaches: their number. In a
 * periodic direction each slab occurs once. */
static int slabs_in_reach(const struct images *s, int k, int mine, double x,
                          int *first)
{
    const struct box *const b = &s->h->mesh->box;
    const double far = images_reach * s->b;
    int last = mine;

    *first = mine;
    while ((b->periodic[k] || *first > 0) && x - edge(b, k, *first) < far &&
           last - *first + 1 < b->n[k])
        --*first;
    while ((b->periodic[k] || last < b->n[k] - 1) &&
           edge(b, k, last + 1) - x < far && last - *first + 1 < b->n[k])
        last++;
    return last - *first + 1;
}

/* The slabs that particle i reaches in direction k and its share of each; they
 * add up to one [EW18 17, 18]. */
static void find_shares(const struct images *s, int i, int k)
{
    const struct mesh *const m = s->h->mesh;
    const int *const n = m->box.n, c = s->h->cell[i];
    const int mine = k == 0   ? c % n[0]
                     : k == 1 ? c / n[0] % n[1]
                              : c / n[0] / n[1];
    const double x = m->centre[3 * c + k] + s->h->offset[3 * i + k];
    double *const share = &s->share[(long)s->wide * (3 * i + k)];
    double sum = 0.0;

    s->count[3 * i + k] = slabs_in_reach(s, k, mine, x, &s->first[3 * i + k]);
    double left = below_edge(s, k, s->first[3 * i + k], x);
    for (int e = 0; e < s->count[3 * i + k]; e++) {
        const double right = below_edge(s, k, s->first[3 * i + k] + e + 1, x);
        sum += share[e] = right - left;
        left = right;
    }
    for (int e = 0; e < s->count[3 * i + k]; e++)
        share[e] /= sum; /* not 0: x is in one of them */
}

static void images_bind(void *state, struct averaging_report *r)
{
    struct images *const s = state;

    (void)r;
#pragma omp parallel for schedule(static) if (s->h->n > 128)
    for (int i = 0; i < s->h->n; i++)
        for (int k = 0; k < 3; k++)
            find_shares(s, i, k);
}

/* Slab e of those in the reach of particle i, as the mesh counts it. */
static int images_slab(const struct images *s, int i, int k, int e)
{
    const int n = s->h->mesh->box.n[k], j = s->first[3 * i + k] + e;
    return j < 0 ? j + n : j >= n ? j - n : j;
}

/* For each row of cells along x that particle i reaches and that is one of the
 * rows first .. last - 1: its number and its share. */
struct row {
    int e[2]; /* next slabs of y and z */
    int row;  /* [-] iy + ny iz */
    double share;
};

static int next_row(const struct images *s, int i, int first, int last,
                    struct row *at)
{
    const int *const count = &s->count[3 * i];
    const double *const share = &s->share[(long)s->wide * 3 * i];

    for (; at->e[1] < count[2]; at->e[1]++, at->e[0] = 0)
        while (at->e[0] < count[1]) {
            const int e = at->e[0]++;
            at->row = images_slab(s, i, 1, e) +
                      s->h->mesh->box.n[1] * images_slab(s, i, 2, at->e[1]);
            if (at->row < first || at->row >= last) continue;
            at->share = share[s->wide + e] * share[2 * s->wide + at->e[1]];
            return 1;
        }
    return 0;
}

/* The part of particle i in the rows first .. last - 1. */
static void spread_one(const struct images *s, int i, int first, int last,
                       int m, const double *q, double *field)
{
    const int nx = s->h->mesh->box.n[0];
    const double *const share = &s->share[(long)s->wide * 3 * i];
    struct row at = {{0, 0}, 0, 0.0};

    while (next_row(s, i, first, last, &at))
        for (int e = 0; e < s->count[3 * i]; e++) {
            const int c = images_slab(s, i, 0, e) + nx * at.row;
            const double w = share[e] * at.share;
            for (int j = 0; j < m; j++)
                field[(long)m * c + j] += w * q[m * i + j];
        }
}

static void images_spread(void *state, int m, const double *q, double *field,
                          struct averaging_report *r)
{
    const struct images *const s = state;
    const struct mesh *const mesh = s->h->mesh;
    const int nx = mesh->box.n[0], rows = mesh->n_cells / nx;

    (void)r;
#pragma omp parallel for schedule(dynamic, 1) if (s->h->n > 128)
    for (int t = 0; t < CHUNKS; t++) {
        const int first = rows * t / CHUNKS, last = rows * (t + 1) / CHUNKS;
        for (long a = (long)m * nx * first; a < (long)m * nx * last; a++)
            field[a] = 0.0;
        for (int i = 0; i < s->h->n && first < last; i++)
            spread_one(s, i, first, last, m, q, field);
        for (int c = nx * first; c < nx * last; c++)
            for (int j = 0; j < m; j++)
                field[(long)m * c + j] /= mesh->V[c];
    }
}

static void images_gather(void *state, int m, const double *field, double *q,
                          struct averaging_report *r)
{
    const struct images *const s = state;
    const int nx = s->h->mesh->box.n[0], rows = s->h->mesh->n_cells / nx;

    (void)r;
#pragma omp parallel for schedule(static) if (s->h->n > 128)
    for (int i = 0; i < s->h->n; i++) {
        const double *const share = &s->share[(long)s->wide * 3 * i];
        struct row at = {{0, 0}, 0, 0.0};
        for (int j = 0; j < m; j++)
            q[m * i + j] = 0.0;
        while (next_row(s, i, 0, rows, &at))
            for (int e = 0; e < s->count[3 * i]; e++) {
                const int c = images_slab(s, i, 0, e) + nx * at.row;
                const double w = share[e] * at.share;
                for (int j = 0; j < m; j++)
                    q[m * i + j] += w * field[(long)m * c + j];
            }
    }
}

/* The largest number of slabs in the reach of any position. */
static int most_slabs(const struct images *s)
{
    const struct box *const b = &s->h->mesh->box;
    int most = 1, first;

    for (int k = 0; k < 3; k++)
        for (int j = 0; j < b->n[k]; j++)
            for (int end = 0; end < 3; end++) {
                const double x =
                    0.5 * ((2 - end) * edge(b, k, j) + end * edge(b, k, j + 1));
                const int n = slabs_in_reach(s, k, j, x, &first);
                most = GSL_MAX_INT(most, GSL_MIN_INT(n + 2, b->n[k]));
            }
    return most;
}

static void *images_create(const struct cell_of_particle *h,
                           const struct averaging_options *o)
{
    struct images *const s = owner_create(sizeof *s);
    const int room = h->ps->capacity;

    s->h = h;
    s->b = o->bandwidth;
    s->wide = most_slabs(s);
    s->first = owner_ints(s, 3 * room);
    s->count = owner_ints(s, 3 * room);
    s->share = owner_doubles(s, 3 * room * s->wide);
    return s;
}

const struct averaging_method images_method = {
    .name = "images",
    .what = "a Gaussian kernel with mirror images at walls",
    .equations = "EW18 17-21",
    .function = "find_shares",
    .keys = {averaging_bandwidth_keys, averaging_delta_keys},
    .gaussian = 1.0,
    .needs_bandwidth = 1,
    .create = images_create,
    .free = owner_free,
    .bind = images_bind,
    .spread = images_spread,
    .gather = images_gather,
    .polyhedral = &images_poly_method,
};
