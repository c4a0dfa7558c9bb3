/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"
#include "output/means/means.h"
#include "facts.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>
#include <math.h>

static const double one = 1.0;

/* The error of `count` samples, each of which comes `times` times, from a
 * normal distribution of variance 1. */
static double error_of(int count, int times)
{
    gsl_rng *const chance = gsl_rng_alloc(gsl_rng_mt19937);
    struct mean_blocks *const b = mean_blocks_create(1);

    for (int i = 0; i < count; i++) {
        const double x = gsl_ran_gaussian(chance, 1.0);
        for (int k = 0; k < times; k++)
            mean_blocks_add(b, &x, &one);
    }
    const double error = mean_blocks_error(b, 0);
    owner_free(b);
    gsl_rng_free(chance);
    return error;
}

/* The spread of 8 block means is itself known to a quarter, and the largest of
 * three estimates is taken: 0.7 to 1.8 is what chance does here. A variance in
 * place of its root, or a missing m - 1 of 8, is outside. */
FACT(independent_samples_have_the_error_of_their_number)
{
    const double error = error_of(4096, 1) * sqrt(4096.0);

    ck_assert_double_gt(error, 0.7);
    ck_assert_double_lt(error, 1.8);
}

/* As rows they would promise a tenth of it. */
FACT(a_sample_that_is_repeated_tells_nothing_new)
{
    const double error = error_of(4096, 100) * sqrt(4096.0);

    ck_assert_double_gt(error, 0.7);
    ck_assert_double_lt(error, 1.8);
}

/* Of 0, 1, ..., m - 1, whose variance is (m^2 - 1) / 12: by blocks of one,
 * m = 8, exactly sqrt((64 - 1) / 12 / 7). Tolerance: rounding. */
FACT(eight_blocks_have_the_error_of_12_6)
{
    struct mean_blocks *const b = mean_blocks_create(1);

    for (int i = 0; i < 7; i++)
        mean_blocks_add(b, &(double){i}, &one);
    ck_assert(isnan(mean_blocks_error(b, 0)));
    mean_blocks_add(b, &(double){7.0}, &one);
    ck_assert_double_eq_tol(mean_blocks_error(b, 0), sqrt(63.0 / 12.0 / 7.0),
                            1e-14);
    owner_free(b);
}

/* 64 steps of a staircase: blocks are joined twice, to 16 of 4 steps, and the
 * largest error is that of 8 of 8, means 3.5, 11.5, ...: 8 times that above. */
FACT(neighbours_are_joined_when_there_is_no_more_room)
{
    struct mean_blocks *const b = mean_blocks_create(2);

    for (int i = 0; i < 64; i++)
        mean_blocks_add(b, (double[]){0.0, i}, (double[]){1.0, 1.0});
    ck_assert_double_eq_tol(mean_blocks_error(b, 1),
                            8.0 * sqrt(63.0 / 12.0 / 7.0), 1e-12);
    ck_assert_double_eq(mean_blocks_error(b, 0), 0.0);
    owner_free(b);
}

/* A block of no weight has no mean; the others have the error that they have
 * without it, but for m of m (m - 1), which counts it: 16 blocks, 8 empty. */
FACT(a_block_without_weight_counts_for_nothing)
{
    const double nothing = 0.0, nowhere = NAN;
    struct mean_blocks *const b = mean_blocks_create(1);

    for (int i = 0; i < 8; i++) {
        mean_blocks_add(b, &(double){i}, &one);
        mean_blocks_add(b, &nowhere, &nothing);
    }
    const double expected = sqrt(16.0 / 15.0 * 42.0) / 8.0;
    ck_assert_double_ge(mean_blocks_error(b, 0), expected * (1.0 - 1e-14));
    ck_assert(!isnan(mean_blocks_error(b, 0)));
    owner_free(b);
}
