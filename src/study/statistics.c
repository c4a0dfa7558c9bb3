/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/statistics.h"

#include "base/alloc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FEWEST_BLOCKS = 8 };

double statistics_mean(int n, const double *x)
{
    double sum = 0.0;

    for (int i = 0; i < n; i++)
        sum += x[i];
    return sum / n;
}

double statistics_error(int n, const double *x)
{
    double sum = 0.0, squares = 0.0;

    /* From the first, so that equal samples have exactly no scatter. */
    for (int i = 0; i < n; i++)
        sum += x[i] - x[0];
    for (int i = 0; i < n; i++)
        squares += pow(x[i] - x[0] - sum / n, 2.0);
    return n > 1 ? sqrt(squares / ((double)n * (n - 1))) : 0.0;
}

/* Halves a series: each block of two becomes its mean. Returns their number. */
static int halve(int n, double *x)
{
    for (int i = 0; i < n / 2; i++)
        x[i] = 0.5 * (x[2 * i] + x[2 * i + 1]);
    return n / 2;
}

double statistics_block_error(int n, const double *x)
{
    double *const block = alloc_doubles(n);
    double largest = n < FEWEST_BLOCKS ? 0.0 : statistics_error(n, x);

    memcpy(block, x, (size_t)n * sizeof *x);
    for (int m = halve(n, block); m >= FEWEST_BLOCKS; m = halve(m, block))
        largest = fmax(largest, statistics_error(m, block));
    free(block);
    return largest;
}

double statistics_between(int n, const double *x, const double *y, double at)
{
    const double near = 1e-9 * (fabs(x[0]) + fabs(x[n - 1])); /* rounding */
    int i = 0;

    if (!(at >= x[0] - near && at <= x[n - 1] + near)) return NAN;
    if (n == 1) return y[0];
    while (i < n - 2 && x[i + 1] < at)
        i++;
    return y[i] + (y[i + 1] - y[i]) * (at - x[i]) / (x[i + 1] - x[i]);
}

double statistics_order(double h_coarse, double e_coarse, double h_fine,
                        double e_fine)
{
    return log(e_coarse / e_fine) / log(h_coarse / h_fine);
}

/* Ratio of the two changes if the order is p. */
static double ratio_at(const double h[3], double p)
{
    const double r = pow(h[1] / h[0], p);

    return (1.0 - r) / (r - pow(h[2] / h[0], p));
}

double statistics_richardson(const double h[3], double ratio)
{
    double low = 0.1, high = 12.0;

    if (!(ratio > ratio_at(h, low) && ratio < ratio_at(h, high))) return NAN;
    for (int i = 0; i < 60; i++) {
        const double middle = 0.5 * (low + high);
        if (ratio_at(h, middle) < ratio)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}
