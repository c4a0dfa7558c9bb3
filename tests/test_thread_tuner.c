/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/thread_tuner.h"
#include "facts.h"

#include <math.h>

/* Time of a step with so many threads [s]: shared work, and what each costs. */
struct machine {
    double work, each;
};

static double step(const struct machine *m, int threads)
{
    return m->work / threads + m->each * threads;
}

/* So many steps; gives the time of all of them. */
static double run(struct thread_tuner *c, const struct machine *m, int steps)
{
    double sum = 0.0;

    for (int k = 0, threads = c->threads; k < steps; k++) {
        const double t = step(m, threads);
        threads = thread_tuner_next(c, t);
        ck_assert_int_ge(threads, 1);
        ck_assert_int_le(threads, c->max_threads);
        sum += t;
    }
    return sum;
}

/* Or one that is as good but for what a trial must gain. */
FACT_FOR_EACH(it_finds_the_number_that_is_fastest, 4)
{
    static const struct machine m[] = {
        {1.0, 2.0}, {1.0, 0.2}, {1.0, 0.06}, {1.0, 0.0}};
    double best = step(&m[_i], 1);
    struct thread_tuner c;

    thread_tuner_init(&c, 12);
    run(&c, &m[_i], 400);
    for (int threads = 2; threads <= 12; threads++)
        best = fmin(best, step(&m[_i], threads));
    ck_assert_double_lt(step(&m[_i], c.threads), best / 0.9);
}

/* Processors are taken away and come back. That they are taken shows in the
 * time that 0.5 * 3 * 128 s of steps had taken before: then in fewer steps. */
FACT(it_follows_what_others_leave)
{
    const struct machine free = {1.0, 0.0}, taken = {1.0, 5.0};
    struct thread_tuner c;

    thread_tuner_init(&c, 2);
    run(&c, &free, 1000);
    ck_assert_int_eq(c.threads, 2);
    run(&c, &taken, 192 / 10 + 10);
    ck_assert_int_eq(c.threads, 1);
    run(&c, &free, 1000);
    ck_assert_int_eq(c.threads, 2);
}

/* Three steps with one thread for 128 times three with two lose three. Where
 * two are ten times as slow as one, a trial is lost after its first step, and
 * costs as much as ten. */
FACT(trials_cost_little)
{
    const struct machine free = {1.0, 0.0}, taken = {1.0, 4.75};
    struct thread_tuner c;

    thread_tuner_init(&c, 2);
    ck_assert_double_lt(run(&c, &free, 10000) / (10000 * 0.5), 1.01);
    thread_tuner_init(&c, 2);
    ck_assert_double_lt(run(&c, &taken, 10000) / (10000 * step(&taken, 1)),
                        1.05);
}

/* Its time is not used. */
FACT(one_thread_stays_one)
{
    struct thread_tuner c;

    thread_tuner_init(&c, 1);
    for (int k = 0; k < 100; k++)
        ck_assert_int_eq(thread_tuner_next(&c, 0.0), 1);
}
