/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/neighbours.h"
#include "facts.h"

#include <omp.h>
#include <stdlib.h>
#include <threads.h>
#include <time.h>

enum { TEAM = 3, ROUNDS = 1000 };

/* Each thread writes its round and reads that of the others after the barrier;
 * the second barrier holds them until all have read. */
FACT(no_thread_passes_the_barrier_before_all_have_arrived)
{
    struct barrier *const b = barrier_create();
    int at[TEAM] = {0}, behind = 0;

#pragma omp parallel num_threads(TEAM) reduction(+ : behind)
    for (int round = 1; round <= ROUNDS; round++) {
        at[omp_get_thread_num()] = round;
        barrier_wait(b, TEAM);
        for (int t = 0; t < TEAM; t++)
            behind += at[t] != round;
        barrier_wait(b, TEAM);
    }
    ck_assert_int_eq(behind, 0);
    barrier_free(b);
}

/* One thread arrives 50 ms late, five times. The processor time of the other
 * [s] is that of its spinning, five times 0.2 ms, and not the quarter of a
 * second. */
FACT(a_thread_that_waits_long_sleeps)
{
    const struct timespec late = {0, 50000000};
    struct barrier *const b = barrier_create();
    const clock_t begin = clock();

#pragma omp parallel num_threads(2)
    for (int round = 0; round < 5; round++) {
        if (omp_get_thread_num() == 0) thrd_sleep(&late, NULL);
        barrier_wait(b, 2);
    }
    ck_assert_double_lt((double)(clock() - begin) / CLOCKS_PER_SEC, 0.1);
    barrier_free(b);
}
