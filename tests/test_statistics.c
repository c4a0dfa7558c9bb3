/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics.h"

#include "base/alloc.h"
#include "facts.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>

/* n values of a signal with the memory a a step, variance 1 and mean 5. */
static void signal_of(int n, double a, int which, double *x)
{
    double y = random_normal(11, which, -1, 0);

    for (int i = 0; i < n; i++) {
        x[i] = 5.0 + y;
        y = a * y + sqrt(1.0 - a * a) * random_normal(11, which, i, 0);
    }
}

/* 1, 2, 3, 10: mean 4, squares 9 + 4 + 1 + 36 over 4, cubes -27 - 8 - 1 + 216.
 */
FACT(ew18_23_mean_of_four_numbers)
{
    static const double x[] = {1.0, 2.0, 3.0, 10.0};
    ck_assert_double_eq(moments_mean(4, x), 4.0);
    ck_assert_double_eq(moments_mean(0, x), 0.0);
}

FACT(ew18_24_deviation_is_divided_by_all)
{
    static const double x[] = {1.0, 2.0, 3.0, 10.0};
    ck_assert_double_eq_tol(moments_deviation(4, x), sqrt(12.5), 1e-15);
    ck_assert_double_eq_tol(moments_skewness(4, x), 45.0 / pow(12.5, 1.5),
                            1e-14);
}

/* The mean of n correlated values has the variance 2 T / (n dt): blocks of 100
 * memories find it, to sqrt(1 / 2 x 100 blocks) = 7 %, three times that here.
 * Taken as independent the error would be three times too small. */
FACT(blocks_give_the_error_of_a_correlated_mean)
{
    enum { N = 50000, BLOCKS = 100 };
    double *const x = alloc_doubles(N);
    const double a = 0.8, memory = (1.0 + a) / (1.0 - a); /* of all lags */

    signal_of(N, a, 1, x);
    ck_assert_double_eq_tol(
        moments_block_error(N, x, BLOCKS) / sqrt(memory / N), 1.0, 0.21);
    ck_assert(isnan(moments_block_error(10, x, 1)));
    ck_assert(isnan(moments_block_error(10, x, 11)));
    free(x);
}

/* Against the sum as it is written, at all lags. */
FACT(ew18_28_transform_is_the_sum_of_products)
{
    enum { N = 37 };
    double x[N], c[N] = {0.0};

    signal_of(N, 0.5, 2, x);
    const double mean = moments_mean(N, x);
    correlation_add(N, x, N, c);
    for (int k = 0; k < N; k++) {
        double sum = 0.0;
        for (int i = 0; i + k < N; i++)
            sum += (x[i] - mean) * (x[i + k] - mean);
        ck_assert_double_eq_tol(c[k], sum / (N - k), 1e-13);
    }
}

/* The mean of a signal is not a part of its fluctuation. */
FACT(ew18_29_mean_is_taken_off)
{
    enum { N = 64 };
    double x[N], y[N], c[8] = {0.0}, d[8] = {0.0};

    signal_of(N, 0.5, 2, x);
    for (int i = 0; i < N; i++)
        y[i] = x[i] + 1000.0;
    correlation_add(N, x, 8, c);
    correlation_add(N, y, 8, d);
    for (int k = 0; k < 8; k++)
        ck_assert_double_eq_tol(c[k], d[k], 1e-8);
}

/* R = exp(-tau), exactly: its integral to t is 1 - exp(-t), the trapezoids'
 * error dt^2 / 12. */
FACT(ew18_30_integral_of_an_exponential_is_its_time)
{
    enum { N = 2000 };
    static double R[N], I[N];

    for (int k = 0; k < N; k++)
        R[k] = exp(-0.01 * k);
    correlation_integral(N, 0.01, R, I);
    ck_assert_double_eq_tol(I[100], 1.0 - exp(-1.0), 1e-5);
    ck_assert_double_eq_tol(I[N - 1], 1.0, 1e-5);
}

/* 50 signals of T = 1, each with a sine of its own phase, half as strong and
 * of the period 8: the running integral swings by 8 / 2 pi / 5, a fourth of T,
 * and the mean over two periods of ends does not. 5 %: that the mean of each
 * signal is taken off lowers T by 2 T / 1638 over ends of 12, 2 %, and three
 * standard errors of 50 x 800 memories are 2 %. */
FACT(ew18_31_a_plateau_takes_out_a_slow_wave)
{
    enum { N = 32768, LAGS = 420, SIGNALS = 50 };
    const double dt = 0.05, period = 8.0, a = exp(-dt);
    double *const x = alloc_doubles(N), *const c = alloc_doubles(LAGS);
    double R[LAGS], I[LAGS], least = 10.0, most = 0.0;

    for (int s = 0; s < SIGNALS; s++) {
        signal_of(N, a, s, x);
        for (int i = 0; i < N; i++)
            x[i] +=
                M_SQRT2 / 2.0 * sin(2.0 * M_PI * (i * dt / period + 0.37 * s));
        correlation_add(N, x, LAGS, c);
    }
    correlation_normalise(LAGS, c, R);
    correlation_integral(LAGS, dt, R, I);
    for (int k = (int)(4.0 / dt); k < LAGS; k++) {
        least = fmin(least, I[k]);
        most = fmax(most, I[k]);
    }
    ck_assert_double_gt(most - least, 0.4);
    /* The wave has a fifth of the variance, so the exponential begins at 4/5.
     */
    ck_assert_double_eq_tol(correlation_time(LAGS, dt, I, 4.0, 20.0) / 0.8, 1.0,
                            0.05);
    free(x);
    free(c);
}

/* A normal sample has a normal density, to four standard errors of a bin. */
FACT(a_density_of_normal_numbers_is_normal)
{
    enum { N = 50000, BINS = 12 };
    double *const x = alloc_doubles(N), p[BINS], whole = 0.0;

    for (int i = 0; i < N; i++)
        x[i] = random_normal(5, i, 0, 0);
    const double inside = density_of(N, x, -3.0, 3.0, BINS, p);
    ck_assert_double_eq_tol(inside, 0.9973, 4.0 * sqrt(0.0027 / N));
    for (int i = 0; i < BINS; i++) {
        const double a = -3.0 + 0.5 * i,
                     q = 0.5 * (erf((a + 0.5) / M_SQRT2) - erf(a / M_SQRT2));
        ck_assert_double_eq_tol(0.5 * p[i], q, 4.0 * sqrt(q / N));
        whole += 0.5 * p[i];
    }
    ck_assert_double_eq_tol(whole, inside, 1e-12);
    free(x);
}

/* Two boxes of four cells, one of them with a sphere in a corner: the mean is
 * over the fluid alone, so that a constant comes back, and a box without fluid
 * gives 0. */
FACT(ew18_25_a_box_has_the_mean_of_its_fluid)
{
    const double V[] = {1.0, 1.0, 2.0, 1.0, 1.0, 1.0};
    const double chi[] = {1.0, 0.25, 0.5, 0.0, 0.0, 0.0};
    const int box[] = {0, 0, 0, 0, 1, 1};
    const double phi[] = {7.0, 1.0, 7.0, 5.0, 7.0, 3.0,
                          7.0, 9.0, 7.0, 9.0, 7.0, 9.0};
    double mean[4], eps[2];

    filter_boxes(6, V, chi, box, 2, phi, 2, mean, eps);
    ck_assert_double_eq_tol(mean[0], 7.0, 1e-14);
    ck_assert_double_eq_tol(mean[1], (1.0 + 0.25 * 5.0 + 1.0 * 3.0) / 2.25,
                            1e-14);
    ck_assert_double_eq_tol(eps[0], 2.25 / 5.0, 1e-15);
    ck_assert_double_eq(mean[2], 0.0);
    ck_assert_double_eq(eps[1], 0.0);
}

/* Values that grow by 1 a unit of Re and 100 a unit of eps, in a wide cloud:
 * near (10, 0.6) they are 70 +- 0.6. Its share of the cloud is known, too. */
FACT(ew18_24_a_sample_takes_what_is_within_a_per_cent)
{
    enum { N = 20000 };
    double *const v = alloc_doubles(4 * N), *const Re = v + N,
                  *const eps = Re + N, *const room = eps + N;

    for (int i = 0; i < N; i++) {
        Re[i] = 9.0 + 2.0 * random_uniform(2, i, 0, 0);
        eps[i] = 0.55 + 0.1 * random_uniform(2, i, 0, 1);
        v[i] = Re[i] + 100.0 * eps[i] + 0.5 * random_normal(2, i, 0, 2);
    }
    const struct sample_moments s =
        sample_near(N, v, Re, eps, 10.0, 0.6, 0.01, room);
    const double share = 0.2 / 2.0 * 0.012 / 0.1;
    ck_assert_double_eq_tol(s.n, N * share, 4.0 * sqrt(N * share));
    /* Besides the noise the two sides of the bin spread by 0.1 and 0.6 over
     * sqrt(3). */
    const double spread = sqrt(0.25 + 0.01 / 3.0 + 0.36 / 3.0);
    ck_assert_double_eq_tol(s.mean, 70.0, 4.0 * spread / sqrt(s.n));
    ck_assert_double_eq_tol(s.deviation, spread, 4.0 * s.deviation_error);
    free(v);
}

/* The velocity that all have is none. */
FACT(granular_temperature_is_that_about_the_mean)
{
    static const double v[] = {3.0, 5.0, 4.0, 4.0};
    ck_assert_double_eq_tol(temperature_of(4, v), 0.5, 1e-15);
}

/* Layers of grains at 0.5, 1.5, ... 9.5 are a bed of height 10. */
FACT(height_of_an_even_bed_is_twice_the_mean)
{
    double y[1000], room[1000];

    for (int i = 0; i < 1000; i++)
        y[i] = 2.0 + i * 7 % 10 + 0.5;
    ck_assert_double_eq_tol(temperature_bed_height(1000, y, 2.0), 10.0, 1e-12);
    ck_assert_double_eq(temperature_percentile(1000, y, 1.0, room), 11.5);
    ck_assert_double_eq_tol(temperature_percentile(1000, y, 0.5, room), 7.0,
                            0.5);
}
