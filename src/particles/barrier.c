/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/barrier.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <threads.h>

#include "base/alloc.h"

enum { SPINS = 10000 }; /* some 10 microseconds */

struct barrier {
    atomic_int here;  /* [-] threads that wait */
    atomic_int round; /* [-] how often the team has met */
    mtx_t lock;
    cnd_t met;
};

struct barrier *barrier_create(void)
{
    struct barrier *const b = alloc_zeroed(1, sizeof *b);

    mtx_init(&b->lock, mtx_plain);
    cnd_init(&b->met);
    return b;
}

void barrier_free(struct barrier *b)
{
    if (b == NULL) return;
    mtx_destroy(&b->lock);
    cnd_destroy(&b->met);
    free(b);
}

/* The last to come begins the next round and wakes who sleeps. */
static void open_up(struct barrier *b)
{
    atomic_store(&b->here, 0);
    mtx_lock(&b->lock);
    atomic_fetch_add(&b->round, 1);
    mtx_unlock(&b->lock);
    cnd_broadcast(&b->met);
}

void barrier_wait(struct barrier *b, int team)
{
    const int round = atomic_load(&b->round);

    if (atomic_fetch_add(&b->here, 1) + 1 == team) {
        open_up(b);
        return;
    }
    for (int spin = 0; spin < SPINS; spin++)
        if (atomic_load_explicit(&b->round, memory_order_acquire) != round)
            return;
    mtx_lock(&b->lock);
    while (atomic_load(&b->round) == round)
        cnd_wait(&b->met, &b->lock);
    mtx_unlock(&b->lock);
}
