/* SPDX-License-Identifier: GPL-3.0-or-later */
/* chunk_loads.c -- where the loads of a chunk are summed. */
#include "dem/fast/chunk.h"

#include <string.h>

/* --- a ring of loads ------------------------------------------------------ */

/* The most loads that are in use at a time: those from the first particle of a
 * block to the last that it reaches. */
static int most_in_use(const struct chunk *s)
{
    int most = 0, first = 0;

    for (int k = 0; k < s->n_blocks; k++) {
        const int last = s->blocks[k].n_loads;
        most = last - first > most ? last - first : most;
        first = s->blocks[k].end - s->begin;
    }
    return most;
}

void chunk_begin_loads(struct chunk *s, struct row_load *ring)
{
    const int most = ring != NULL ? most_in_use(s) : CHUNK_RING + 1;
    int size = CHUNK_BLOCK;

    while (size < most)
        size *= 2;
    s->sum = size <= CHUNK_RING ? ring : s->load;
    s->round = size <= CHUNK_RING ? size - 1 : -1;
}

void chunk_zero_loads(struct chunk *s, int first, int last)
{
    for (int q = first; q < last; q++)
        *chunk_load(s, q) = (struct row_load){.zero = 0.0};
    if (s->part != NULL && last > first)
        memset(s->part + first, 0, (size_t)(last - first) * sizeof *s->part);
}

void chunk_end_loads(struct chunk *s)
{
    for (int q = s->end - s->begin; s->sum != s->load && q < s->window; q++)
        s->load[q] = *chunk_load(s, q);
    s->sum = s->load;
    s->round = -1;
}

/* --- loads on other chunks ------------------------------------------------ */

int chunk_shared_loads(const struct chunk *s, const struct chunk *t, int n)
{
    const int size = s->end - s->begin;

    if (size == 0) return 0;
    const int reached = t->window - (s->begin - t->begin + n) % n;
    return reached < 0 ? 0 : reached < size ? reached : size;
}

/* Adds the first n rows. */
static void add_rows(struct row_load *to, const struct row_load *from, int n)
{
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            to[i].F[k] += from[i].F[k];
            to[i].turn[k] += from[i].turn[k];
        }
}

void chunk_add_loads(struct chunk *chunks, int count, int s, int n, int begin,
                     int end)
{
    struct chunk *const own = &chunks[s];

    for (int back = 1; back < count; back++) {
        const struct chunk *const t = &chunks[(s - back + count) % count];
        const int offset = (own->begin - t->begin + n) % n;
        const int last = own->begin + chunk_shared_loads(own, t, n);
        const int many = (end < last ? end : last) - begin;
        const int first = begin - own->begin;
        add_rows(chunk_load(own, first), t->load + first + offset, many);
        if (own->has_budget)
            add_rows(own->part[first], t->part[first + offset],
                     many * ENERGY_PARTS);
    }
}
