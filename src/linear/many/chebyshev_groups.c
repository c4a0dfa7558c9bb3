/* SPDX-License-Identifier: GPL-3.0-or-later */
/* chebyshev_groups.c -- the series of linear/chebyshev.h for groups of fields
 * at once. Chapter "Linear solvers". */
#include "linear/chebyshev.h"

#include "base/field_groups.h"
#include "base/parallel_ranges.h"

/* Number of fields for which m fields are allocated: a multiple of the group
 * width, because a partial group takes as long as a whole one. */
static int padded(int m)
{
    return m == 1 ? 1
                  : (m + FIELD_GROUPS_WIDTH - 1) / FIELD_GROUPS_WIDTH *
                        FIELD_GROUPS_WIDTH;
}

/* Ly = (2 / lambda) L y in row i, for `width` fields from the g-th of m on. */
FIELD_GROUPS_KERNEL row(int width, int g, int i, int m,
                        const struct chebyshev *s, const double *y, double *Ly)
{
    const struct csr *const K = s->K;
    const double diag = K->diag[i], factor = s->factor[i];
    const double *const yi = y + (long)m * i + g;

    for (int f = 0; f < width; f++)
        Ly[f] = diag * yi[f];
    for (int e = K->start[i]; e < K->start[i + 1]; e++) {
        const double a = K->a[e];
        const double *const yj = y + (long)m * K->col[e] + g;

        for (int f = 0; f < width; f++)
            Ly[f] += a * yj[f];
    }
    for (int f = 0; f < width; f++)
        Ly[f] *= factor;
}

/* Computes y_1 = u - Ly and the sum of the first two terms. */
FIELD_GROUPS_KERNEL chebyshev_groups_begin_rows(int width, int g, int first,
                                                int last, int m,
                                                const struct chebyshev *s,
                                                const double *u,
                                                double *restrict next)
{
    const double c0 = s->c[0], c1 = s->c[1];
    double *restrict sum = s->sum;

    for (int i = first; i < last; i++) {
        const long at = (long)m * i + g;
        double Ly[FIELD_GROUPS_WIDTH], n[FIELD_GROUPS_WIDTH],
            S[FIELD_GROUPS_WIDTH];

        row(width, g, i, m, s, u, Ly);
        for (int f = 0; f < width; f++) {
            n[f] = u[at + f] - Ly[f];
            S[f] = c0 * u[at + f] + c1 * n[f];
        }
        for (int f = 0; f < width; f++)
            next[at + f] = n[f];
        for (int f = 0; f < width; f++)
            sum[at + f] = S[f];
    }
}

/* Computes y_(k+1) = 2 (y_k - Ly) - y_(k-1), in the place of y_(k-1), and adds
 * its term to the sum. */
FIELD_GROUPS_KERNEL term_rows(int width, int g, int first, int last, int m,
                              const struct chebyshev *s, double c,
                              const double *y, double *restrict next)
{
    double *restrict sum = s->sum;

    for (int i = first; i < last; i++) {
        const long at = (long)m * i + g;
        double Ly[FIELD_GROUPS_WIDTH], n[FIELD_GROUPS_WIDTH],
            S[FIELD_GROUPS_WIDTH];

        row(width, g, i, m, s, y, Ly);
        for (int f = 0; f < width; f++) {
            n[f] = 2.0 * (y[at + f] - Ly[f]) - next[at + f];
            S[f] = sum[at + f] + c * n[f];
        }
        for (int f = 0; f < width; f++)
            next[at + f] = n[f];
        for (int f = 0; f < width; f++)
            sum[at + f] = S[f];
    }
}

static void chebyshev_groups_begin(int first, int last, int m,
                                   const struct chebyshev *s, const double *u,
                                   double *next)
{
    FOR_FIELD_GROUPS(m, chebyshev_groups_begin_rows, first, last, m, s, u,
                     next);
}

static void chebyshev_groups_term(int first, int last, int m,
                                  const struct chebyshev *s, double c,
                                  const double *y, double *next)
{
    FOR_FIELD_GROUPS(m, term_rows, first, last, m, s, c, y, next);
}

/* Copies m fields of each row from rows of one length to rows of another. */
static void chebyshev_groups_copy(int first, int last, int m,
                                  const double *from, int from_length,
                                  double *to, int to_length)
{
    for (int i = first; i < last; i++)
        for (int f = 0; f < m; f++)
            to[(long)to_length * i + f] = from[(long)from_length * i + f];
}

static void chebyshev_groups_apply(struct chebyshev *s, int m, double *u)
{
    const int n = s->K->n, length = padded(m);
    double *y = s->y[0], *next = s->y[1];

    PARALLEL_RANGES(n, m, chebyshev_groups_copy, m, u, m, y, length);
    PARALLEL_RANGES(n, 4 * length, chebyshev_groups_begin, length, s, y, next);
    for (int k = 2; k <= s->products; k++) {
        double *const newest = next;

        next = y;
        y = newest;
        PARALLEL_RANGES(n, 4 * length, chebyshev_groups_term, length, s,
                        s->c[k], y, next);
    }
    PARALLEL_RANGES(n, m, chebyshev_groups_copy, m, s->sum, length, u, m);
}

const struct chebyshev_loop chebyshev_groups = {"groups", padded,
                                                chebyshev_groups_apply};
