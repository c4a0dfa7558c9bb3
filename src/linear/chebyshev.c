/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/chebyshev.h"

#include <assert.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>

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
    s->c = owner_doubles(s, last + 1);
    for (int k = last; k > 0; k--)
        sum += s->c[k] = coefficient(k, z);
    s->c[0] = 1.0 - sum; /* so that a constant stays as it is */
}

/* Number of fields for which m fields are allocated: a multiple of the group
 * width, because a partial group takes as long as a whole one. */
static int padded(int m)
{
    return m == 1 ? 1
                  : (m + FIELD_GROUPS_WIDTH - 1) / FIELD_GROUPS_WIDTH *
                        FIELD_GROUPS_WIDTH;
}

struct chebyshev *chebyshev_create(const struct csr *K, const double *V,
                                   double T, double tail, int m)
{
    struct chebyshev *const s = owner_create(sizeof *s);
    double lambda = 0.0; /* [1/m^2] Gershgorin's bound */

    assert(m >= 1 && T >= 0.0 && tail > 0.0);
    s->K = K;
    s->m = m;
    for (int i = 0; i < K->n; i++)
        lambda = fmax(lambda, 2.0 * K->diag[i] / V[i]);
    s->factor = owner_doubles(s, K->n);
    for (int i = 0; i < K->n; i++)
        s->factor[i] = lambda > 0.0 ? 2.0 / (lambda * V[i]) : 0.0;
    chebyshev_find_coefficients(s, lambda * T, tail);
    for (int j = 0; j < 2; j++)
        s->y[j] = owner_doubles(s, K->n * padded(m));
    s->sum = owner_doubles(s, K->n * padded(m));
    return s;
}

int chebyshev_products(const struct chebyshev *s)
{
    return s->products;
}

/* The k-th term in the place of the last but one, y_k = 2 (y_(k-1) - Ly) -
 * y_(k-2) with Ly = (2 / lambda) L y_(k-1), and y_1 = y_0 - Ly; adds it to the
 * sum, for `width` fields from the g-th of m on. `begins`: k is 1. */
FIELD_GROUPS_KERNEL chebyshev_term(int width, int g, int first, int last, int m,
                                   const struct chebyshev *s, int begins,
                                   double c, const double *y,
                                   double *restrict next)
{
    const struct csr *const K = s->K;
    double *restrict sum = s->sum;

    for (int i = first; i < last; i++) {
        const long at = (long)m * i + g;
        double Ly[FIELD_GROUPS_WIDTH], n[FIELD_GROUPS_WIDTH],
            S[FIELD_GROUPS_WIDTH];

        for (int f = 0; f < width; f++)
            Ly[f] = K->diag[i] * y[at + f];
        for (int e = K->start[i]; e < K->start[i + 1]; e++) {
            const double a = K->a[e];
            const double *const beside = y + (long)m * K->col[e] + g;

            for (int f = 0; f < width; f++)
                Ly[f] += a * beside[f];
        }
        for (int f = 0; f < width; f++) {
            const double step = y[at + f] - Ly[f] * s->factor[i];

            n[f] = begins ? step : 2.0 * step - next[at + f];
            S[f] = (begins ? s->c[0] * y[at + f] : sum[at + f]) + c * n[f];
        }
        for (int f = 0; f < width; f++)
            next[at + f] = n[f];
        for (int f = 0; f < width; f++)
            sum[at + f] = S[f];
    }
}

static void chebyshev_terms(int first, int last, int m,
                            const struct chebyshev *s, int k, const double *y,
                            double *next)
{
    if (k == 1)
        FOR_FIELD_GROUPS(m, chebyshev_term, first, last, m, s, 1, s->c[k], y,
                         next);
    else
        FOR_FIELD_GROUPS(m, chebyshev_term, first, last, m, s, 0, s->c[k], y,
                         next);
}

/* Copies m fields of each row from rows of one length to rows of another. */
static void chebyshev_copy(int first, int last, int m, const double *from,
                           int from_length, double *to, int to_length)
{
    for (int i = first; i < last; i++)
        for (int f = 0; f < m; f++)
            to[(long)to_length * i + f] = from[(long)from_length * i + f];
}

void chebyshev_apply(struct chebyshev *s, int m, double *u)
{
    const int n = s->K->n, length = padded(m);
    double *y = s->y[0], *next = s->y[1];

    assert(m >= 1 && m <= s->m);
    PARALLEL_RANGES(n, m, chebyshev_copy, m, u, m, y, length);
    for (int k = 1; k <= s->products; k++) {
        double *const newest = next;

        PARALLEL_RANGES(n, 4 * length, chebyshev_terms, length, s, k, y, next);
        next = y;
        y = newest;
    }
    PARALLEL_RANGES(n, m, chebyshev_copy, m, s->sum, length, u, m);
}
