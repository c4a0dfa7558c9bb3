/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/chebyshev.h"

#include "base/alloc.h"
#include "linear/reduce.h"
#include "linear/strips.h"

#include <assert.h>
#include <gsl/gsl_sf_bessel.h>
#include <math.h>
#include <stdlib.h>

struct chebyshev {
    const struct csr *K; /* borrowed */
    double *factor;      /* [1/m] 2 / (lambda V) of each row */
    int products;
    double *c;          /* [-] products + 1 coefficients */
    int m;              /* fields there is room for */
    double *y[2], *sum; /* two terms y_k, and the series so far */
};

/* c_k = (2 - [k = 0]) exp(-z/2) I_k(z/2); positive, and all together 1. */
static double coefficient(int k, double z)
{
    return (k == 0 ? 1.0 : 2.0) * gsl_sf_bessel_In_scaled(k, 0.5 * z);
}

/* How many terms hold a coefficient above rounding: they fall faster than
 * geometrically once k exceeds some sqrt(z). */
static int all_terms(double z)
{
    int k = 1;

    while (coefficient(k, z) > 1e-18)
        k++;
    return k;
}

/* The coefficients up to where the rest of them adds up to less than tail. */
static void find_coefficients(struct chebyshev *s, double z, double tail)
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

    assert(m >= 1 && m <= REDUCE_FIELDS && T >= 0.0 && tail > 0.0);
    s->K = K;
    s->m = m;
    for (int i = 0; i < K->n; i++)
        lambda = fmax(lambda, 2.0 * K->diag[i] / V[i]);
    s->factor = alloc_doubles(K->n);
    for (int i = 0; i < K->n; i++)
        s->factor[i] = lambda > 0.0 ? 2.0 / (lambda * V[i]) : 0.0;
    find_coefficients(s, lambda * T, tail);
    for (int j = 0; j < 2; j++)
        s->y[j] = alloc_doubles(K->n * m);
    s->sum = alloc_doubles(K->n * m);
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

/* One term for the rows of a range: next = a (y - factor K y) - b next, where
 * next holds the term before y; sum = c next, added to d times what the sum
 * was of y: the first term begins it, the others continue it. */
static inline void term_rows(int first, int last, int m,
                             const struct chebyshev *s, int k, const double *y,
                             double *restrict next)
{
    const struct csr *const K = s->K;
    const double c = s->c[k], c0 = s->c[0];

    for (int i = first; i < last; i++) {
        const double *const yi = y + (long)m * i;
        double *const ni = next + (long)m * i, *const ui = s->sum + (long)m * i;
        double Ky[REDUCE_FIELDS];

        for (int f = 0; f < m; f++)
            Ky[f] = K->diag[i] * yi[f];
        for (int e = K->start[i]; e < K->start[i + 1]; e++)
            for (int f = 0; f < m; f++)
                Ky[f] += K->a[e] * y[(long)m * K->col[e] + f];
        for (int f = 0; f < m; f++) {
            const double t = yi[f] - s->factor[i] * Ky[f];

            ni[f] = k == 1 ? t : 2.0 * t - ni[f];
            ui[f] = (k == 1 ? c0 * yi[f] : ui[f]) + c * ni[f];
        }
    }
}

/* Loops of known length for the frequent numbers of fields. */
static void term(int first, int last, int m, const struct chebyshev *s, int k,
                 const double *y, double *next)
{
    switch (m) {
    case 4:
        term_rows(first, last, 4, s, k, y, next);
        break;
    case 8:
        term_rows(first, last, 8, s, k, y, next);
        break;
    default:
        term_rows(first, last, m, s, k, y, next);
    }
}

static void copy(int first, int last, int m, const double *from, double *to)
{
    for (long i = (long)m * first; i < (long)m * last; i++)
        to[i] = from[i];
}

void chebyshev_apply(struct chebyshev *s, int m, double *u)
{
    const double *y = u;

    assert(m >= 1 && m <= s->m);
    for (int k = 1; k <= s->products; k++) {
        double *const next = s->y[k % 2];

        if (k == 2) STRIPS_RUN(s->K->n, m, copy, m, u, next);
        STRIPS_RUN(s->K->n, 4 * m, term, m, s, k, y, next);
        y = next;
    }
    STRIPS_RUN(s->K->n, m, copy, m, s->sum, u);
}
