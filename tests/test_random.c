/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/statistics.h"

#include "facts.h"

#include <math.h>

enum { N = 100000 };

/* The normal number k of three sequences: of one particle in time, of particles
 * at one time, of seeds. */
static double number(int which, int k)
{
    return which == 0   ? random_normal(1, 4, k, 0)
           : which == 1 ? random_normal(1, k, 4, 0)
                        : random_normal((unsigned long)k, 4, 4, 0);
}

/* Moments 0, 1, 0, 3 and no correlation with the next: within four standard
 * errors, sqrt(1, 2, 6, 24, 1 / N). */
FACT_FOR_EACH(ew18_34_noise_is_white_and_normal, 3)
{
    double sum[5] = {0.0};

    for (int k = 0; k < N; k++) {
        const double z = number(_i, k), next = number(_i, k + 1);
        sum[0] += z;
        sum[1] += z * z;
        sum[2] += z * z * z - 3.0 * z;
        sum[3] += z * z * z * z;
        sum[4] += z * next;
    }
    ck_assert_double_eq_tol(sum[0] / N, 0.0, 4.0 / sqrt(N));
    ck_assert_double_eq_tol(sum[1] / N, 1.0, 4.0 * sqrt(2.0 / N));
    ck_assert_double_eq_tol(sum[2] / N, 0.0, 4.0 * sqrt(6.0 / N));
    ck_assert_double_eq_tol(sum[3] / N, 3.0, 4.0 * sqrt(96.0 / N));
    ck_assert_double_eq_tol(sum[4] / N, 0.0, 4.0 / sqrt(N));
}

/* All decades of the unit interval, and never an end of the normal one. */
FACT(uniform_numbers_fill_the_interval)
{
    int part[10] = {0};

    for (int k = 0; k < N; k++) {
        const double u = random_uniform(3, k, 0, 1);
        ck_assert(u >= 0.0 && u < 1.0);
        part[(int)(10.0 * u)]++;
    }
    for (int i = 0; i < 10; i++) /* 4 of sqrt(N 0.1 0.9) */
        ck_assert_double_eq_tol(part[i], 0.1 * N, 4.0 * sqrt(0.09 * N));
}
