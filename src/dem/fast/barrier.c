/* SPDX-License-Identifier: GPL-3.0-or-later */
/* barrier.c -- a barrier that spins for a while and then sleeps.
 * Chapter "Fast particles". */
#include <stdatomic.h>
#include <stdlib.h>
#include <threads.h>

#include "base/alloc.h"
#include "base/clock.h"
#include "dem/fast/neighbours.h"

/* Waking a thread takes as long as the work of a chunk, so a waiting thread
 * spins for about the duration of its part of a step before it sleeps. */
static const double spin_time = 2e-4; /* [s] */

enum { POLLS = 50 }; /* [-] iterations between two readings of the clock */

struct barrier {
    atomic_int n_waiting; /* [-] threads that wait */
    atomic_int round;     /* [-] number of barriers passed */
    mtx_t lock;
    cnd_t opened;
};

struct barrier *barrier_create(void)
{
    struct barrier *const b = alloc_zeroed(1, sizeof *b);

    mtx_init(&b->lock, mtx_plain);
    cnd_init(&b->opened);
    return b;
}

void barrier_free(struct barrier *b)
{
    if (b == NULL) return;
    mtx_destroy(&b->lock);
    cnd_destroy(&b->opened);
    free(b);
}

/* The last thread to arrive begins the next round and wakes sleepers. */
static void open_up(struct barrier *b)
{
    atomic_store(&b->n_waiting, 0);
    mtx_lock(&b->lock);
    atomic_fetch_add(&b->round, 1);
    mtx_unlock(&b->lock);
    cnd_broadcast(&b->opened);
}

/* Spins until the round is over or the time limit is reached. A spinning thread
 * yields the processor, which helps if there are more threads than processors.
 */
static int is_over(struct barrier *b, int round)
{
    const double begin = clock_now();

    do {
        for (int poll = 0; poll < POLLS; poll++)
            if (atomic_load_explicit(&b->round, memory_order_acquire) != round)
                return 1;
        thrd_yield();
    } while (clock_now() - begin < spin_time);
    return 0;
}

void barrier_wait(struct barrier *b, int team)
{
    const int round = atomic_load(&b->round);

    if (atomic_fetch_add(&b->n_waiting, 1) + 1 == team) {
        open_up(b);
        return;
    }
    if (is_over(b, round)) return;
    mtx_lock(&b->lock);
    while (atomic_load(&b->round) == round)
        cnd_wait(&b->opened, &b->lock);
    mtx_unlock(&b->lock);
}
