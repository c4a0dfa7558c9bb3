/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/chebyshev.h"

#include "base/alloc.h"
#include "base/parallel_ranges.h"

#include <assert.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
