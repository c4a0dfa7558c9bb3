/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics/moments.h"

#include <math.h>

double moments_mean(int n, const double *x)
{
    double sum = 0.0;

    for (int i = 0; i < n; i++)
        sum += x[i];
    return n > 0 ? sum / n : 0.0; /* [EW18 23] */
}

/* Mean of the p-th power of the deviations. */
static double central(int n, const double *x, int p)
{
    const double mean = moments_mean(n, x);
    double sum = 0.0;

    for (int i = 0; i < n; i++) {
        const double d = x[i] - mean;
        sum += p == 2 ? d * d : d * d * d;
    }
    return n > 0 ? sum / n : 0.0;
}

double moments_deviation(int n, const double *x)
{
    return sqrt(central(n, x, 2)); /* [EW18 24] */
}

double moments_skewness(int n, const double *x)
{
    const double s = moments_deviation(n, x);

    return s > 0.0 ? central(n, x, 3) / (s * s * s) : 0.0;
}

double moments_block_error(int n, const double *x, int blocks)
{
    const int length = blocks > 0 ? n / blocks : 0;
    const double *const first = x + (n - length * blocks);
    const double mean = moments_mean(length * blocks, first);
    double square = 0.0;

    if (blocks < 2 || length < 1) return NAN;
    for (int b = 0; b < blocks; b++) {
        const double d = moments_mean(length, first + b * length) - mean;
        square += d * d;
    }
    return sqrt(square / (blocks - 1.0) / blocks);
}
