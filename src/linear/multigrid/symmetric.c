/* SPDX-License-Identifier: GPL-3.0-or-later */
/* symmetric.c -- a symmetric matrix stored by diagonals.
 * Chapter "Linear solvers".
 *
 * On a box, owner and neighbour of a link are almost always one of a few
 * distances apart: 1, n_x, n_x n_y. Such links are stored by distance, each
 * coefficient once and without an index, and the product is vectorised:
 *
 *     (A x)_i = diag_i x_i + sum_k (u_k,i x_(i+d_k) + u_k,(i-d_k) x_(i-d_k))
 *
 * Links with any other distance are stored in a csr matrix. In an irregular
 * mesh all links are stored there, and the product is as fast as that of csr.
 *
 * A preconditioner needs few digits, and its time is spent on memory traffic,
 * so smoothing is done in single precision (measured: half the time). The
 * product for the outer iteration is in double precision, with a second copy of
 * the coefficients.
 */
#include <stdlib.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "linear/multigrid/level_matrix.h"
#include "linear/reduce.h"

enum {
    BLOCK = 512, /* rows in a block, small enough for the first-level cache */
    WORTH_IT =
        8, /* a distance is a band if at least one row in this number has it */
};

/* Sets the distances of the bands: those that occur most often, the most
 * frequent first. */
static void find_bands(struct symmetric *S, const int *owner,
                       const int *neighbour)
{
    int *const count = alloc_ints(S->n);

    for (int l = 0; l < S->n_links; l++)
        count[abs(neighbour[l] - owner[l])]++;
    while (S->n_bands < SYMMETRIC_BANDS) {
        int best = 0;

        count[0] = S->n / WORTH_IT;
        for (int d = 1; d < S->n; d++)
            if (count[d] > count[best]) best = d;
        if (best == 0) break;
        count[best] = 0;
        S->distance[S->n_bands++] = best;
        if (best > S->pad) S->pad = best;
    }
    S->pad = (S->pad + 15) / 16 * 16; /* keeps vectors aligned to 64 bytes */
    free(count);
}

static void list_rest_rows(struct symmetric *S)
{
    const int *const start = S->rest->start;
    int n = 0;

    S->rest_row = owner_ints(S, S->n);
    S->rest_from = owner_ints(S, S->n + 1);
    for (int i = 0; i < S->n; i++) {
        S->rest_from[i] = n;
        if (start[i + 1] > start[i]) S->rest_row[n++] = i;
    }
    S->rest_from[S->n] = n;
}

/* Adds link l to the last run, or as the first of a new one. */
static void add_to_runs(struct symmetric *S, int *room, struct link_run next)
{
    struct link_run *const last = S->run + S->n_runs - 1;

    if (S->n_runs > 0 && last->band == next.band &&
        (next.band == -2 || last->place + last->n == next.place)) {
        last->n++;
        return;
    }
    S->run = alloc_room(S->run, S->n_runs, room, sizeof *S->run);
    S->run[S->n_runs++] = next;
}

/* Assigns each link a place: in a band if it is free, else in the csr matrix of
 * the rest. */
static void place_links(struct symmetric *S, const int *owner,
                        const int *neighbour)
{
    int *const own = alloc_ints(S->n_links), *const nei =
                                                 alloc_ints(S->n_links);
    int n_rest = 0, room = 0;

    for (int l = 0; l < S->n_links; l++) {
        const int i = owner[l], j = neighbour[l], low = i < j ? i : j;
        struct link_run next = {l, 1, 0, low};
        int k = 0;

        while (k < S->n_bands && S->distance[k] != abs(j - i))
            k++;
        next.band = i == j ? -2 : k < S->n_bands ? k : -1;
        if (next.band >= 0 && S->band[k][low] != 0.0F) next.band = -1;
        if (next.band >= 0) S->band[k][low] = 1.0F;
        if (next.band == -1) {
            own[n_rest] = i;
            nei[n_rest] = j;
            next.place = n_rest++;
        }
        add_to_runs(S, &room, next);
    }
    S->run = alloc_grown(S->run, S->n_runs, S->n_runs, sizeof *S->run);
    owner_take(S, S->run);
    if (n_rest > 0) {
        S->rest = owner_join(S, csr_create(S->n, n_rest, own, nei));
        list_rest_rows(S);
    }
    free(own);
    free(nei);
}

float *symmetric_vector(struct symmetric *S)
{
    const size_t n = (size_t)S->n + 2 * (size_t)S->pad;

    return (float *)owner_zeroed(S, n, sizeof(float)) + S->pad;
}

struct symmetric *symmetric_create(int n, int n_links, const int *owner,
                                   const int *neighbour, int exact)
{
    struct symmetric *const S = owner_create(sizeof *S);

    S->n = n;
    S->n_links = n_links;
    S->diag = owner_zeroed(S, (size_t)n, sizeof *S->diag);
    find_bands(S, owner, neighbour);
    S->inverse = symmetric_vector(S);
    for (int k = 0; k < S->n_bands; k++)
        S->band[k] = symmetric_vector(S);
    place_links(S, owner, neighbour);
    if (!exact) return S;
    S->exact_diag = owner_doubles(S, n);
    for (int k = 0; k < S->n_bands; k++)
        S->exact[k] = owner_doubles(S, n + S->pad) + S->pad;
    return S;
}

/* y[i - first] = the diagonal and the first bands of row i, times x. Called
 * with a constant number of bands, so that the loop over rows is the one that
 * vectorises. */
static inline void band_rows(const struct symmetric *S, int bands, int first,
                             int last, const float *x, float *restrict y)
{
    const float *u[3], *v[3], *up[3], *down[3];

    for (int k = 0; k < bands; k++) {
        u[k] = S->band[k] + first;
        v[k] = u[k] - S->distance[k];
        up[k] = x + first + S->distance[k];
        down[k] = x + first - S->distance[k];
    }
    for (int i = 0; i < last - first; i++) {
        float sum = S->diag[first + i] * x[first + i];

        for (int k = 0; k < bands; k++)
            sum += u[k][i] * up[k][i] + v[k][i] * down[k][i];
        y[i] = sum;
    }
}

static void other_bands(const struct symmetric *S, int first, int last,
                        const float *x, float *restrict y)
{
    for (int k = 3; k < S->n_bands; k++) {
        const int d = S->distance[k];
        const float *const u = S->band[k];

        for (int i = first; i < last; i++)
            y[i - first] += u[i] * x[i + d] + u[i - d] * x[i - d];
    }
}

static void rest_rows(const struct symmetric *S, int first, int last,
                      const float *x, float *y)
{
    const struct csr *const R = S->rest;

    for (int s = S->rest_from[first]; s < S->rest_from[last]; s++) {
        const int i = S->rest_row[s];
        double sum = 0.0;

        for (int e = R->start[i]; e < R->start[i + 1]; e++)
            sum += R->a[e] * (double)x[R->col[e]];
        y[i - first] += (float)(sum * S->unit);
    }
}

/* y[i - first] = row i of A x, for first <= i < last. */
static void symmetric_rows(const struct symmetric *S, int first, int last,
                           const float *x, float *y)
{
    switch (S->n_bands) {
    case 0:
        band_rows(S, 0, first, last, x, y);
        break;
    case 1:
        band_rows(S, 1, first, last, x, y);
        break;
    case 2:
        band_rows(S, 2, first, last, x, y);
        break;
    default:
        band_rows(S, 3, first, last, x, y);
    }
    other_bands(S, first, last, x, y);
    if (S->rest != NULL) rest_rows(S, first, last, x, y);
}

void symmetric_residual_rows(int first, int last, const struct symmetric *S,
                             const float *b, const float *x, float *r)
{
    float Ax[BLOCK];

    for (int end; first < last; first = end) {
        end = symmetric_lesser(first + BLOCK, last);
        symmetric_rows(S, first, end, x, Ax);
        for (int i = first; i < end; i++)
            r[i] = b[i] - Ax[i - first];
    }
}

void symmetric_residual(const struct symmetric *S, const float *b,
                        const float *x, float *r)
{
    PARALLEL_RANGES(S->n, 2, symmetric_residual_rows, S, b, x, r);
}

void symmetric_relax_rows(int first, int last, const struct symmetric *S,
                          const float *b, const float *x, float alpha,
                          const float *w, float beta, float gamma, float *y)
{
    float Ax[BLOCK];

    for (int end; first < last; first = end) {
        end = symmetric_lesser(first + BLOCK, last);
        symmetric_rows(S, first, end, x, Ax);
        for (int i = first; i < end; i++)
            y[i] = alpha * x[i] + beta * w[i] +
                   gamma * S->inverse[i] * (b[i] - Ax[i - first]);
    }
}

void symmetric_relax(const struct symmetric *S, const float *b, const float *x,
                     float alpha, const float *w, float beta, float gamma,
                     float *y)
{
    PARALLEL_RANGES(S->n, 2, symmetric_relax_rows, S, b, x, alpha, w, beta,
                    gamma, y);
}

/* Computes rows first .. last - 1 of A x in double. The tests of the ends have
 * an effect only near the ends of the vector. */
static void exact_rows(const struct symmetric *S, int first, int last,
                       const double *x, double *restrict y)
{
    for (int i = first; i < last; i++)
        y[i] = S->exact_diag[i] * x[i];
    for (int k = 0; k < S->n_bands; k++) {
        const int d = S->distance[k];
        const int begin = first > d ? first : d;
        const int end = last < S->n - d ? last : S->n - d;
        const double *const u = S->exact[k];

        for (int i = first; i < end; i++)
            y[i] += u[i] * x[i + d];
        for (int i = begin; i < last; i++)
            y[i] += u[i - d] * x[i - d];
    }
    if (S->rest == NULL) return;
    for (int s = S->rest_from[first]; s < S->rest_from[last]; s++) {
        const int i = S->rest_row[s];

        for (int e = S->rest->start[i]; e < S->rest->start[i + 1]; e++)
            y[i] += S->rest->a[e] * x[S->rest->col[e]];
    }
}

static double multiply_rows(int first, int last, const struct symmetric *S,
                            const double *x, double *y)
{
    const int begin = first;

    for (int end; first < last; first = end) {
        end = symmetric_lesser(first + BLOCK, last);
        exact_rows(S, first, end, x, y);
    }
    return reduce_range(begin, last, x, y);
}

double symmetric_multiply(const struct symmetric *S, const double *x, double *y)
{
    double xy;

    PARALLEL_SUM(xy, S->n, 2, multiply_rows, S, x, y);
    return xy;
}

/* The run that contains link l. */
static int run_of(const struct symmetric *S, int l)
{
    int low = 0, high = S->n_runs;

    while (high - low > 1) {
        const int middle = low + (high - low) / 2;

        if (S->run[middle].first <= l)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Writes coefficients g to the places place ... of a band, or of the rest. */
static void write_run(struct symmetric *S, int n, int band, int place,
                      const double *g)
{
    const struct csr *const R = S->rest;

    for (int i = 0; i < n && band >= 0; i++)
        S->band[band][place + i] = (float)(-g[i] * S->unit);
    for (int i = 0; i < n && band >= 0 && S->exact_diag != NULL; i++)
        S->exact[band][place + i] = -g[i];
    for (int i = 0; i < n && band == -1; i++)
        R->a[R->upper[place + i]] = R->a[R->lower[place + i]] = -g[i];
}

/* Writes the coefficients of links first .. last - 1, each to its own place. */
static void write_links(int first, int last, struct symmetric *S,
                        const double *g)
{
    for (int r = run_of(S, first); first < last; r++) {
        const struct link_run *const run = &S->run[r];
        const int skip = first - run->first;
        const int n = symmetric_lesser(run->n - skip, last - first);

        write_run(S, n, run->band, run->place + skip, g + first);
        first += n;
    }
}

/* The sum of the entries off the diagonal of row i. */
static double links_of_row(const struct symmetric *S, int i)
{
    double rounded = 0.0, sum = 0.0;

    for (int k = 0; k < S->n_bands; k++) {
        const int d = S->distance[k];

        if (S->exact_diag != NULL)
            sum += S->exact[k][i] + S->exact[k][i - d];
        else
            rounded += (double)S->band[k][i] + (double)S->band[k][i - d];
    }
    if (S->rest != NULL)
        for (int e = S->rest->start[i]; e < S->rest->start[i + 1]; e++)
            sum += S->rest->a[e];
    return sum + rounded / S->unit;
}

static void write_diagonal(int first, int last, struct symmetric *S,
                           const double *sums)
{
    for (int i = first; i < last; i++) {
        const double diag = sums[i] - links_of_row(S, i);

        if (S->exact_diag != NULL) S->exact_diag[i] = diag;
        S->diag[i] = (float)(S->unit * diag);
        S->inverse[i] = S->diag[i] > 0.0F ? 1.0F / S->diag[i] : 0.0F;
    }
}

void symmetric_fill(struct symmetric *S, const double *g, const double *sums,
                    double unit)
{
    S->unit = unit;
    PARALLEL_RANGES(S->n_links, 2, write_links, S, g);
    PARALLEL_RANGES(S->n, 8, write_diagonal, S, sums);
}
