/* SPDX-License-Identifier: GPL-3.0-or-later */
/* chunk_loads.c -- where the loads of a chunk are summed. */
#include "dem/fast/neighbours.h"

#include <omp.h>
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

void chunk_begin_loads(struct chunk *s, struct row_load *ring, int most)
{
    const int needed = most > 0 ? most_in_use(s) : 0;
    int size = CHUNK_BLOCK;

    while (size < needed && size <= most)
        size *= 2;
    s->sum = size <= most ? ring : s->load;
    s->round = size <= most ? size - 1 : -1;
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

void chunk_add_loads(struct chunk *chunks, int count, int s, int n, int begin,
                     int end)
{
    struct chunk *const own = &chunks[s];

    for (int back = 1; back < count; back++) {
        const struct chunk *const t = &chunks[(s - back + count) % count];
        const int offset = (own->begin - t->begin + n) % n;
        const int shared = own->begin + chunk_shared_loads(own, t, n);
        const int last = shared < end ? shared : end;
        for (int q = begin - own->begin; q < last - own->begin; q++)
            row_load_add(chunk_load(own, q), chunk_load(t, q + offset));
        for (int q = begin - own->begin;
             own->has_budget && q < last - own->begin; q++)
            for (int a = 0; a < ENERGY_PARTS; a++)
                row_load_add(&own->part[q][a], &t->part[q + offset][a]);
    }
}

/* --- of a step --------------------------------------------------------------
 */

int chunk_loads_shared(const struct neighbours *nb, int s,
                       const struct step_parameters *by)
{
    const int *const around = nb->rows->box.periodic;
    const int n = nb->rows->n, first = neighbours_balanced_range(nb).first;
    int most = 0;

    if (nb->surfaces != NULL || by->n_attractions > 0) return n;
    if (nb->n_chunks == 1 && (around[0] || around[1] || around[2])) return n;
    for (int t = 0; t < nb->n_chunks; t++) {
        const int done = first <= t && t <= s;
        const int m =
            done ? 0 : chunk_shared_loads(&nb->chunks[s], &nb->chunks[t], n);
        most = m > most ? m : most;
    }
    return most;
}

/* NULL: the loads are needed after the blocks. */
static struct row_load *ring_of_thread(const struct neighbours *nb, int s,
                                       const struct step_parameters *by)
{
    if (!by->passing || by->budget || nb->ps->clumps != NULL) return NULL;
    return nb->ring + (2 * omp_get_thread_num() + s % 2) * nb->ring_size;
}

void chunk_loads_begin(const struct neighbours *nb, int s,
                       const struct step_parameters *by)
{
    const int waits = chunk_loads_shared(nb, s, by) > 0;
    struct row_load *const ring = waits ? NULL : ring_of_thread(nb, s, by);

    chunk_begin_loads(&nb->chunks[s], ring, ring != NULL ? nb->ring_size : 0);
}

/* The loads on other chunks stay in the ring if the next chunk takes them all
 * from there, before the one after it needs the ring. */
void chunk_loads_end(const struct neighbours *nb, int s,
                     const struct step_parameters *by)
{
    const struct chunk_range mine = neighbours_balanced_range(nb);
    struct chunk *const own = &nb->chunks[s];

    if (s > mine.first) chunk_begin_loads(own - 1, NULL, 0);
    if (s + 1 == mine.last || own->begin + own->window > own[1].end ||
        chunk_loads_shared(nb, s + 1, by) > 0)
        chunk_end_loads(own);
}
