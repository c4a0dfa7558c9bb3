/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/reduce.h"

#include "base/parallel_ranges.h"

enum { LANES = 32 };

/* The sum of x y over first ... last - 1, in 32 interleaved sums. */
double reduce_range(int first, int last, const double *x, const double *y)
{
    double lane[LANES] = {0.0};
    double sum = 0.0;
    int i = first;

    for (; i + LANES <= last; i += LANES)
        for (int k = 0; k < LANES; k++)
            lane[k] += x[i + k] * y[i + k];
    for (; i < last; i++)
        sum += x[i] * y[i];
    for (int k = 0; k < LANES; k++)
        sum += lane[k];
    return sum;
}

double reduce_range_scaled(int first, int last, const double *x, const float *y,
                           double factor)
{
    double lane[LANES] = {0.0};
    double sum = 0.0;
    int i = first;

    for (; i + LANES <= last; i += LANES)
        for (int k = 0; k < LANES; k++)
            lane[k] += x[i + k] * (factor * (double)y[i + k]);
    for (; i < last; i++)
        sum += x[i] * (factor * (double)y[i]);
    for (int k = 0; k < LANES; k++)
        sum += lane[k];
    return sum;
}

double reduce_dot(int n, const double *x, const double *y)
{
    double sum;

    PARALLEL_SUM(sum, n, 1, reduce_range, x, y);
    return sum;
}

/* Sums eight rows at a time in 8 m lanes, so that vectors are full for any m.
 */
static inline void range_many(int first, int last, int m, const double *x,
                              const double *y, double *dot)
{
    double lane[8 * REDUCE_FIELDS] = {0.0};
    const int width = 8 * m;
    int i = first;

    for (; i + 8 <= last; i += 8) {
        const double *const xi = x + (long)m * i, *const yi = y + (long)m * i;

        for (int k = 0; k < width; k++)
            lane[k] += xi[k] * yi[k];
    }
    for (; i < last; i++)
        for (int k = 0; k < m; k++)
            lane[k] += x[(long)m * i + k] * y[(long)m * i + k];
    for (int k = 0; k < m; k++)
        dot[k] = 0.0;
    for (int k = 0; k < width; k++)
        dot[k % m] += lane[k];
}

/* The loops for 3 and for 8 fields, the most frequent numbers, have a length
 * that the compiler knows. */
void reduce_range_many(int first, int last, int m, const double *x,
                       const double *y, double *dot)
{
    switch (m) {
    case 3:
        range_many(first, last, 3, x, y, dot);
        break;
    case 8:
        range_many(first, last, 8, x, y, dot);
        break;
    default:
        range_many(first, last, m, x, y, dot);
    }
}
