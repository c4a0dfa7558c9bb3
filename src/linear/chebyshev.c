/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/chebyshev.h"

#include <assert.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "linear/field_groups.h"
#include "base/parallel_ranges.h"

/* c_k = (2 - [k = 0]) exp(-z/2) I_k(z/2) [-]. All c_k are positive, and their
 * sum is 1. */
static double coefficient(int k, double z)
{
    return (k == 0 ? 1.0 : 2.0) * gsl_sf_bessel_In_scaled(k, 0.5 * z);
}

/* The number of coefficients above 1e-18, which is below rounding: they
 * decrease faster than geometrically once k exceeds about sqrt(z). */
static int all_terms(double z)
{
    int k = 1;

    while (coefficient(k, z) > 1e-18)
        k++;
    return k;
}

/* Sets the coefficients; those at the end whose sum is less than tail are left
 * out. */
static void chebyshev_find_coefficients(struct chebyshev *s, double z,
                                        double tail)
{
    const int terms = all_terms(z);
    double left = 0.0, sum = 0.0;
    int last = terms;

    for (; last > 1 && left + coefficient(last, z) < tail; last--)
        left += coefficient(last, z);
    s->products = last;
    s->c = alloc_doubles(last + 1);
    for (int k = last; k > 0; k--)
        sum += s->c[k] = coefficient(k, z);
    s->c[0] = 1.0 - sum; /* so that a constant stays as it is */
}

struct chebyshev *chebyshev_create(const struct csr *K, const double *V,
                                   double T, double tail, int m)
{
    struct chebyshev *const s = alloc_zeroed(1, sizeof *s);
    double lambda = 0.0; /* [1/m^2] Gershgorin's bound */

    assert(m >= 1 && T >= 0.0 && tail > 0.0);
    s->loop = &chebyshev_groups;
    s->K = K;
    s->m = m;
    for (int i = 0; i < K->n; i++)
        lambda = fmax(lambda, 2.0 * K->diag[i] / V[i]);
    s->factor = alloc_doubles(K->n);
    for (int i = 0; i < K->n; i++)
        s->factor[i] = lambda > 0.0 ? 2.0 / (lambda * V[i]) : 0.0;
    chebyshev_find_coefficients(s, lambda * T, tail);
    const int size = K->n * s->loop->fields(m);
    for (int j = 0; j < 2; j++)
        s->y[j] = alloc_doubles(size);
    s->sum = alloc_doubles(size);
    return s;
}

void chebyshev_free(struct chebyshev *s)
{
    if (s == NULL) return;
    free(s->factor);
    free(s->c);
    free(s->y[0]);
    free(s->y[1]);
    free(s->sum);
    free(s);
}

int chebyshev_products(const struct chebyshev *s)
{
    return s->products;
}

/* The k-th term in the place of the last but one: y_(k+1) = 2 (y_k - Ly) -
 * y_(k-1), Ly = (2 / lambda) L y_k; and adds it to the sum. */
static void chebyshev_term(int first, int last, int m,
                           const struct chebyshev *s, int k, const double *y,
                           double *next)
{
    const struct csr *const K = s->K;

    for (int i = first; i < last; i++)
        for (int f = 0; f < m; f++) {
            const long at = (long)m * i + f;
            double Ly = K->diag[i] * y[at];

            for (int e = K->start[i]; e < K->start[i + 1]; e++)
                Ly += K->a[e] * y[(long)m * K->col[e] + f];
            const double step = y[at] - Ly * s->factor[i];
            next[at] = k == 1 ? step : 2.0 * step - next[at];
            s->sum[at] =
                (k == 1 ? s->c[0] * y[at] : s->sum[at]) + s->c[k] * next[at];
        }
}

static void chebyshev_apply_plain(struct chebyshev *s, int m, double *u)
{
    const size_t size = (size_t)s->K->n * (size_t)m * sizeof *u;
    double *y = s->y[0], *next = s->y[1];

    memcpy(y, u, size);
    for (int k = 1; k <= s->products; k++) {
        double *const newest = next;

        PARALLEL_RANGES(s->K->n, 4 * m, chebyshev_term, m, s, k, y, next);
        next = y;
        y = newest;
    }
    memcpy(u, s->sum, size);
}

static int as_many(int m)
{
    return m;
}

const struct chebyshev_loop chebyshev_plain = {"plain", as_many,
                                               chebyshev_apply_plain};

void chebyshev_apply(struct chebyshev *s, int m, double *u)
{
    assert(m >= 1 && m <= s->m);
    s->loop->apply(s, m, u);
}

/* The series of linear/chebyshev.h for groups of fields
 * at once. Chapter "Linear solvers". */

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
