/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics/correlation.h"

#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/statistics/moments.h"

/* The power of 2 that holds the series and as many zeros, so that what leaves
 * at one end does not come in at the other. */
static int padded_length(int n)
{
    int length = 1;

    while (length < 2 * n)
        length *= 2;
    return length;
}

/* |X|^2 of a transform in GSL's order: the real parts, then the imaginary. */
static void square(int length, double *X)
{
    X[0] *= X[0];
    for (int k = 1; k < length / 2; k++) {
        X[k] = X[k] * X[k] + X[length - k] * X[length - k];
        X[length - k] = 0.0;
    }
    X[length / 2] *= X[length / 2];
}

void correlation_add(int n, const double *x, int lags, double *c)
{
    const int length = padded_length(n);
    const double mean = moments_mean(n, x);
    double *const X = alloc_doubles(length);

    for (int i = 0; i < n; i++)
        X[i] = x[i] - mean; /* [EW18 29] */
    gsl_fft_real_radix2_transform(X, 1, (size_t)length);
    square(length, X);
    gsl_fft_halfcomplex_radix2_inverse(X, 1, (size_t)length);
    for (int k = 0; k < lags; k++)
        c[k] += X[k] / (n - k); /* [EW18 28], above the line */
    free(X);
}

void correlation_normalise(int lags, const double *c, double *R)
{
    for (int k = 0; k < lags; k++)
        R[k] = c[0] > 0.0 ? c[k] / c[0] : 0.0; /* [EW18 28] */
}

void correlation_integral(int lags, double dt, const double *R, double *I)
{
    for (int k = 0; k < lags; k++) /* [EW18 30] */
        I[k] = k == 0 ? 0.0 : I[k - 1] + 0.5 * dt * (R[k - 1] + R[k]);
}

double correlation_time(int lags, double dt, const double *I, double from,
                        double to)
{
    double sum = 0.0;
    int n = 0;

    for (int k = 0; k < lags; k++)
        if (k * dt >= from - 1e-9 * dt && k * dt <= to + 1e-9 * dt) {
            sum += I[k];
            n++;
        }
    return n > 0 ? sum / n : 0.0; /* [EW18 31] */
}
