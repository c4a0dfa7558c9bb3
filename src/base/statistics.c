/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>
#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"

/* --- moments -------------------------------------------------------------- */

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

/* --- correlation ---------------------------------------------------------- */

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

/* --- density -------------------------------------------------------------- */

double density_of(int n, const double *x, double low, double high, int n_bins,
                  double *p)
{
    const double width = (high - low) / n_bins;
    int inside = 0;

    for (int i = 0; i < n_bins; i++)
        p[i] = 0.0;
    for (int i = 0; i < n; i++) {
        if (!(x[i] >= low && x[i] < high)) continue;
        p[number_clamped((x[i] - low) / width, 0, n_bins - 1)] += 1.0;
        inside++;
    }
    for (int i = 0; i < n_bins && n > 0; i++)
        p[i] /= n * width;
    return n > 0 ? (double)inside / n : 0.0;
}

/* --- filter --------------------------------------------------------------- */

void filter_boxes(int n_fine, const double *V, const double *chi,
                  const int *box, int m, const double *phi, int n_boxes,
                  double *mean, double *chi_mean)
{
    double *const volume = alloc_doubles(n_boxes);

    memset(mean, 0, (size_t)(m * n_boxes) * sizeof *mean);
    memset(chi_mean, 0, (size_t)n_boxes * sizeof *chi_mean);
    for (int c = 0; c < n_fine; c++) {
        volume[box[c]] += V[c];
        chi_mean[box[c]] += chi[c] * V[c];
        for (int k = 0; k < m; k++)
            mean[m * box[c] + k] += chi[c] * V[c] * phi[m * c + k];
    }
    for (int b = 0; b < n_boxes; b++) {
        for (int k = 0; k < m; k++)
            mean[m * b + k] = chi_mean[b] > 0.0 ? mean[m * b + k] / chi_mean[b]
                                                : 0.0; /* [EW18 25] */
        if (volume[b] > 0.0) chi_mean[b] /= volume[b];
    }
    free(volume);
}

/* --- sample --------------------------------------------------------------- */

static int sample_is_near(double x, double x_0, double tolerance)
{
    return fabs(x - x_0) <= tolerance * x_0;
}

struct sample_moments sample_near(int n, const double *value, const double *Re,
                                  const double *eps, double Re_0, double eps_0,
                                  double tolerance, double *room)
{
    struct sample_moments s = {0};

    for (int i = 0; i < n; i++)
        if (sample_is_near(Re[i], Re_0, tolerance) &&
            sample_is_near(eps[i], eps_0, tolerance))
            room[s.n++] = value[i];
    s.mean = moments_mean(s.n, room);
    s.deviation = moments_deviation(s.n, room);
    s.deviation_error = s.n > 0 ? s.deviation / sqrt(2.0 * s.n) : 0.0;
    return s;
}

/* --- temperature ---------------------------------------------------------- */

double temperature_of(int n, const double *v)
{
    const double s = moments_deviation(n, v);

    return s * s;
}

double temperature_bed_height(int n, const double *y, double floor)
{
    return n > 0 ? 2.0 * (moments_mean(n, y) - floor) : 0.0;
}

double temperature_percentile(int n, const double *y, double q, double *room)
{
    if (n == 0) return 0.0;
    memcpy(room, y, (size_t)n * sizeof *room);
    gsl_sort(room, 1, (size_t)n);
    return gsl_stats_quantile_from_sorted_data(room, 1, (size_t)n, q);
}

/* --- random --------------------------------------------------------------- */

static const double two_to_53 = 9007199254740992.0;

static uint64_t mix(unsigned long seed, long i, long j, int which)
{
    const uint64_t part[4] = {seed, (uint64_t)i, (uint64_t)j, (uint64_t)which};
    uint64_t z = 0;

    for (int k = 0; k < 4; k++) {
        z += part[k] + 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        z ^= z >> 31;
    }
    return z >> 11;
}

double random_uniform(unsigned long seed, long i, long j, int which)
{
    return (double)mix(seed, i, j, which) / two_to_53;
}

/* The middles of the 2^53 parts of 0 .. 1, so that neither 0 nor 1 is returned.
 */
double random_normal(unsigned long seed, long i, long j, int which)
{
    return gsl_cdf_ugaussian_Pinv(((double)mix(seed, i, j, which) + 0.5) /
                                  two_to_53);
}
