/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/reduce.h"

#include <assert.h>

enum { LANES = 32 };

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

double reduce_strips(const double strip[REDUCE_STRIPS])
{
    double sum = 0.0;

    for (int s = 0; s < REDUCE_STRIPS; s++)
        sum += strip[s];
    return sum;
}

double reduce_dot(int n, const double *x, const double *y)
{
    double strip[REDUCE_STRIPS];

#pragma omp parallel for schedule(static) if (n > REDUCE_THREADED)
    for (int s = 0; s < REDUCE_STRIPS; s++)
        strip[s] =
            reduce_range(reduce_strip(n, s), reduce_strip(n, s + 1), x, y);
    return reduce_strips(strip);
}

/* Eight rows at a time make 8 m lanes: full vectors for any m. */
static inline void strip_dot_many(int first, int last, int m, const double *x,
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

void reduce_dot_many(int n, int m, const double *x, const double *y,
                     double *dot)
{
    double strip[REDUCE_STRIPS][REDUCE_FIELDS];

    assert(m >= 1 && m <= REDUCE_FIELDS);
#pragma omp parallel for schedule(static) if (n > REDUCE_THREADED / m)
    for (int s = 0; s < REDUCE_STRIPS; s++) {
        const int first = reduce_strip(n, s), last = reduce_strip(n, s + 1);

        switch (m) { /* the frequent counts get loops of known length */
        case 3:
            strip_dot_many(first, last, 3, x, y, strip[s]);
            break;
        case 8:
            strip_dot_many(first, last, 8, x, y, strip[s]);
            break;
        default:
            strip_dot_many(first, last, m, x, y, strip[s]);
        }
    }
    for (int k = 0; k < m; k++)
        dot[k] = 0.0;
    for (int s = 0; s < REDUCE_STRIPS; s++)
        for (int k = 0; k < m; k++)
            dot[k] += strip[s][k];
}
