/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/thread_tuner.h"

#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/clock.h"

enum { TRIAL = 3 }; /* [-] steps */

/* Trials are frequent at first, and as long as they change the number; each
 * that does not doubles the interval to the next. Intervals are measured in
 * time, not in steps, so that slow steps are tried as soon as fast ones. */
static const double soon = 1.0, late = 128.0; /* [-] */

/* The gain that a trial must show: more than steps differ by in any case. */
static const double worth_it = 0.9; /* [-] */

static void thread_tuner_measure(struct thread_tuner *c)
{
    c->measuring = 1;
    c->steps_left = TRIAL;
    c->elapsed = 0.0;
}

void thread_tuner_init(struct thread_tuner *c, int most)
{
    *c = (struct thread_tuner){.max_threads = most,
                               .threads = 1,
                               .target = most,
                               .trial_interval = 0.5 * soon};
    thread_tuner_measure(c);
}

/* Trials with more and with fewer threads alternate. */
static void begin_trial(struct thread_tuner *c)
{
    c->reference_time = c->elapsed;
    c->trial_was_larger = c->threads == 1 ||
                          (!c->trial_was_larger && c->threads < c->max_threads);
    c->trial_threads = c->trial_was_larger ? c->target : c->threads / 2;
    c->measuring = 0;
    c->steps_left = TRIAL;
    c->elapsed = 0.0;
}

/* A trial that takes longer than the reference time ends early. If more threads
 * were not faster, half of them are tried next. */
static void end_trial(struct thread_tuner *c)
{
    const int better =
        c->steps_left == 0 && c->elapsed < worth_it * c->reference_time;

    if (better) {
        c->threads = c->trial_threads;
        c->reference_time = c->elapsed;
    }
    if (c->trial_was_larger)
        c->target = better ? c->max_threads : c->target / 2;
    if (c->target <= c->threads) c->target = c->max_threads;
    c->trial_interval = better ? soon
                        : 2.0 * c->trial_interval < late
                            ? 2.0 * c->trial_interval
                            : late;
    c->trial_threads = 0;
    c->elapsed = 0.0;
}

int thread_tuner_next(struct thread_tuner *c, double seconds)
{
    if (c->max_threads == 1) return 1;
    c->elapsed += seconds;
    c->steps_left--;
    if (c->trial_threads > 0) {
        if (c->steps_left == 0 || c->elapsed > c->reference_time) end_trial(c);
    } else if (c->measuring) {
        if (c->steps_left == 0) begin_trial(c);
    } else if (c->elapsed >= c->trial_interval * c->reference_time) {
        thread_tuner_measure(c);
    }
    return c->trial_threads > 0 ? c->trial_threads : c->threads;
}

/* With one thread there are no trials, and the clock is not read. */
struct thread_tuner *thread_tuner_create(void)
{
    struct thread_tuner *const c = alloc_zeroed(1, sizeof *c);

    thread_tuner_init(c, omp_get_max_threads());
    omp_set_num_threads(1);
    return c;
}

void thread_tuner_before_step(struct thread_tuner *c)
{
    if (c->max_threads > 1) c->step_start = clock_now();
}

void thread_tuner_after_step(struct thread_tuner *c)
{
    if (c->max_threads > 1)
        omp_set_num_threads(thread_tuner_next(c, clock_now() - c->step_start));
}

void thread_tuner_free(struct thread_tuner *c)
{
    omp_set_num_threads(c->max_threads);
    free(c);
}
