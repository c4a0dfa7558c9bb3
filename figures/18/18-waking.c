/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What two threads cost each other: an OpenMP region with nothing to do, a
 * barrier of ours at which both arrive at once, and one at which one has slept.
 */
#include <omp.h>
#include <stdio.h>
#include <time.h>

#include "base/clock.h"
#include "dem/fast/neighbours.h"

enum { TIMES = 20000, SLEEPS = 200 };

static double region(void)
{
    int there[2][64] = {{0}};
    const double begin = clock_now();

    for (int k = 0; k < TIMES; k++)
#pragma omp parallel num_threads(2)
        there[omp_get_thread_num()][0]++;
    return (clock_now() - begin) / TIMES;
}

static double both_awake(struct barrier *b)
{
    double begin = 0.0;

#pragma omp parallel num_threads(2)
    {
        barrier_wait(b, 2);
        if (omp_get_thread_num() == 0) begin = clock_now();
        for (int k = 0; k < TIMES; k++)
            barrier_wait(b, 2);
    }
    return (clock_now() - begin) / TIMES;
}

/* One thread is a millisecond late; how long until the other, who sleeps by
 * then, has answered at the next barrier? */
static double waking(struct barrier *b)
{
    double sum = 0.0;

#pragma omp parallel num_threads(2)
    for (int k = 0; k < SLEEPS; k++) {
        double begin = clock_now();
        if (omp_get_thread_num() == 0)
            while (clock_now() - begin < 1e-3)
                ;
        begin = clock_now();
        barrier_wait(b, 2);
        barrier_wait(b, 2);
        if (omp_get_thread_num() == 0) sum += clock_now() - begin;
    }
    return sum / SLEEPS;
}

int main(void)
{
    struct barrier *const b = barrier_create();

    region(); /* the threads are made */
    printf("region = %.1f us\n", 1e6 * region());
    printf("barrier = %.1f us\n", 1e6 * both_awake(b));
    printf("waking = %.1f us\n", 1e6 * waking(b));
    barrier_free(b);
    return 0;
}
