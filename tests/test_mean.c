/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"
#include "output/means/means.h"
#include "facts.h"
#include "kept.h"

#include <math.h>

/* 1e9 + {4, 7, 13, 16}: mean 10, spread sqrt(22.5). The difference of sums of
 * squares would have lost all digits of the spread. The tolerance is rounding
 * of 1e9 (1e-7) and its effect on the spread. */
FACT(mean_and_spread_keep_their_digits_far_from_zero)
{
    const double x[4] = {1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0};
    struct mean *const m = mean_create(1);

    for (int i = 0; i < 4; i++)
        mean_add(m, 0.25, &x[i], NULL);
    ck_assert_double_eq_tol(m->value[0], 1e9 + 10.0, 2e-7);
    ck_assert_double_eq_tol(mean_spread(m, 0), sqrt(22.5), 1e-6);
    owner_free(m);
    owner_free(NULL);
}

/* Weights 1, 2, 5 of 2, -1, 4: mean 20/8, spread from the definition. */
FACT(weights_count_as_repetitions)
{
    const double x[3] = {2.0, -1.0, 4.0}, w[3] = {1.0, 2.0, 5.0};
    struct mean *const weighted = mean_create(1);
    struct mean *const repeated = mean_create(1);

    for (int i = 0; i < 3; i++) {
        mean_add(weighted, 0.5, &x[i], &w[i]);
        for (int k = 0; k < (int)w[i]; k++)
            mean_add(repeated, 0.5, &x[i], NULL);
    }
    ck_assert_double_eq_tol(weighted->value[0], 2.5, 4e-16 * 4.0);
    ck_assert_double_eq_tol(mean_spread(weighted, 0), sqrt(36.0 / 8.0), 2e-15);
    ck_assert_double_eq_tol(repeated->value[0], 2.5, 4e-16 * 8.0);
    ck_assert_double_eq_tol(mean_spread(repeated, 0), sqrt(36.0 / 8.0), 4e-15);
    owner_free(weighted);
    owner_free(repeated);
}

/* A stretch of 3 dt weighs three times as much. */
FACT(long_intervals_count_more)
{
    struct mean *const m = mean_create(1);

    mean_add(m, 3.0, &(double){1.0}, NULL);
    mean_add(m, 1.0, &(double){5.0}, NULL);
    ck_assert_double_eq(m->value[0], 2.0);
    owner_free(m);
}

/* A sample of weight 0 may be nan: a velocity where nothing moves. */
FACT(without_a_weight_nothing_counts)
{
    const double x[2] = {7.0, 7.0}, nothing[2] = {NAN, NAN};
    const double first[2] = {0.0, 1.0}, never[2] = {0.0, 0.0};
    struct mean *const m = mean_create(2);

    ck_assert(isnan(m->value[0]));
    mean_add(m, 1.0, x, first);
    mean_add(m, 1.0, nothing, never);
    ck_assert(isnan(m->value[0]) && isnan(mean_spread(m, 0)));
    ck_assert_double_eq(m->value[1], 7.0);
    ck_assert_double_eq(mean_spread(m, 1), 0.0);
    owner_free(m);
}

FACT(the_state_carries_a_mean_over_an_interruption)
{
    const double x[4] = {0.1, 0.7, 0.4, 0.9};
    struct mean *const through = mean_create(1), *const first = mean_create(1);
    struct mean *const second = mean_create(1);

    for (int i = 0; i < 4; i++)
        mean_add(through, 0.1, &x[i], NULL);
    for (int i = 0; i < 2; i++)
        mean_add(first, 0.1, &x[i], NULL);
    struct kept *const kept = kept_create();
    mean_state(first, &kept->state);
    mean_state(second, kept_load(kept));
    kept_free(kept);
    for (int i = 2; i < 4; i++)
        mean_add(second, 0.1, &x[i], NULL);
    ck_assert(second->value[0] == through->value[0]); /* bit for bit */
    ck_assert(mean_spread(second, 0) == mean_spread(through, 0));
    owner_free(through);
    owner_free(first);
    owner_free(second);
}
