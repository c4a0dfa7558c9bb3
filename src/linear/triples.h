/* triples.h -- one number a cell times three a cell, at vector speed.
 *
 * Where each of three components side by side is multiplied by the same number,
 * a compiler shuffles both. It is faster to write that number three times, for
 * a few cells at once, and to go on with plain loops (measured: 1.6 times for a
 * product, more where several numbers of a cell are used).
 */
#ifndef TRIPLES_H
#define TRIPLES_H

#include "linear/reduce.h"

enum { TRIPLES = 128 }; /* cells at once: what is written stays in the cache */

/* a3[3 i + k] = a[i] for n cells. */
static inline void triples_spread(int n, const double *restrict a,
                                  double *restrict a3)
{
    for (int i = 0; i < n; i++) {
        a3[3 * i] = a[i];
        a3[3 * i + 1] = a[i];
        a3[3 * i + 2] = a[i];
    }
}

/* y[3 i + k] += factor a[i] x[3 i + k] for n cells; y is apart from the rest.
 */
static inline void triples_add(int n, double factor, const double *restrict a,
                               const double *restrict x, double *restrict y)
{
    double a3[3 * TRIPLES];

    for (int i = 0; i < n; i += TRIPLES) {
        const int m = n - i < TRIPLES ? n - i : TRIPLES;
        const double *restrict from = x + 3L * i;
        double *restrict to = y + 3L * i;

        triples_spread(m, a + i, a3);
        for (int j = 0; j < 3 * m; j++)
            to[j] += factor * a3[j] * from[j];
    }
}

/* sum[k] += a[i] x[3 i + k] over n cells. */
static inline void triples_sum(int n, const double *restrict a,
                               const double *restrict x, double sum[3])
{
    double a3[3 * TRIPLES], part[3];

    for (int i = 0; i < n; i += TRIPLES) {
        const int m = n - i < TRIPLES ? n - i : TRIPLES;

        triples_spread(m, a + i, a3);
        reduce_range_many(0, m, 3, a3, x + 3L * i, part);
        for (int k = 0; k < 3; k++)
            sum[k] += part[k];
    }
}

#endif
