/* SPDX-License-Identifier: GPL-3.0-or-later */
/* choose.c -- the contacts of a chunk, chosen from its lists.
 * Chapter "Neighbours". */
#include <math.h>
#include <string.h>

#include "dem/fast/chunk.h"

/* Pairs whose distances are computed together; and of one owner, that are
 * written at a time. */
enum { NEAR_LANES = 64, OWNED = 8 };

/* Copies the contacts to where the loads are, which nobody needs any more, and
 * returns them there. */
static struct chunk_contacts set_aside(struct chunk *s)
{
    const struct chunk_contacts *const c = &s->contacts;
    const size_t n = (size_t)c->n_pairs + (size_t)c->n_walls;
    const size_t columns = s->has_rolling ? 6 : 3, size = n * sizeof(double);
    struct chunk_contacts old = {.n_pairs = c->n_pairs, .n_walls = c->n_walls};

    if (n == 0) return old; /* there may be histories */
    chunk_reserve_loads(s, columns * size + n * sizeof(int), 0);
    double *to = (void *)s->load;
    for (int k = 0; k < 3; k++, to += n)
        old.xi[k] = memcpy(to, c->xi[k], size);
    for (int k = 0; s->has_rolling && k < 3; k++, to += n)
        old.roll_angle[k] = memcpy(to, c->roll_angle[k], size);
    old.list_index = memcpy(to, c->list_index, n * sizeof(int));
    return old;
}

/* Names the owners of the `count` pairs from q on, the first of which belongs
 * to particle `a` of the chunk or a later one; returns the last of theirs. */
static int name_owners(const struct chunk *s, int q, int count, int a,
                       int owner[NEAR_LANES + OWNED])
{
    const int *const start = s->pairs.start;

    for (int p = 0;; a++) {
        const int next = start[a + 1] - q, end = next < count ? next : count;
        for (; p < end; p += OWNED)
            for (int k = 0; k < OWNED; k++)
                owner[p + k] = s->begin + a;
        if (end == count) return a;
        p = end;
    }
}

/* Sets near = 1 for those of the first `count` pairs whose distance is less
 * than the sum of what they reach. */
static inline void find_near(const struct rows *b, const int *restrict i,
                             const int *restrict j, int count, int periodic,
                             int *restrict near)
{
    static const double sign[4] = {-1, -1, -1, 1};
    const double *const L = b->box.length, *const a = b->box.inverse;
    double row[NEAR_LANES][4] = {{0.0}};

    for (int p = 0; p < count; p++) {
        const double *restrict const x = (const double *)&b->chosen[i[p]];
        const double *restrict const y = (const double *)&b->chosen[j[p]];
#pragma omp simd
        for (int k = 0; k < 4; k++)
            row[p][k] = x[k] + sign[k] * y[k];
    }
#pragma omp simd
    for (int p = 0; p < NEAR_LANES; p++) {
        double x = row[p][0], y = row[p][1], z = row[p][2];
        if (periodic) {
            x -= L[0] * rint(x * a[0]);
            y -= L[1] * rint(y * a[1]);
            z -= L[2] * rint(z * a[2]);
        }
        near[p] = x * x + y * y + z * z < row[p][3] * row[p][3];
    }
}

/* Writes owners and list indices of the near pairs; returns their number.
 * Writes every pair, and advances the slot only for near ones, which avoids a
 * branch. Where the memory ends, the pairs that follow are taken to be near as
 * often as those before. */
static int choose_pairs(struct chunk *s, const struct rows *b)
{
    const int *const around = b->box.periodic;
    const int periodic = around[0] || around[1] || around[2];
    const struct neighbour_list *const v = &s->pairs;
    struct chunk_contacts *const c = &s->contacts;
    int near[NEAR_LANES], owner[NEAR_LANES + OWNED], slot = 0;

    for (int q = 0, a = 0; q < v->n; q += NEAR_LANES) {
        const int count = v->n - q < NEAR_LANES ? v->n - q : NEAR_LANES;
        if (slot + NEAR_LANES > c->capacity)
            chunk_reserve_contacts(
                s, NEAR_LANES + (int)((long)slot * v->n / (q + 1)), slot);
        a = name_owners(s, q, count, a, owner);
        if (periodic)
            find_near(b, owner, v->partner + q, count, 1, near);
        else
            find_near(b, owner, v->partner + q, count, 0, near);
        for (int p = 0; p < count; p++) {
            c->owner[slot] = owner[p];
            c->list_index[slot] = q + p;
            slot += near[p];
        }
    }
    return slot;
}

/* The same for walls, from slot `first` on; returns the slot after the last. */
static int choose_walls(struct chunk *s, const struct rows *b, int first)
{
    const struct neighbour_list *const v = &s->walls;
    struct chunk_contacts *const c = &s->contacts;
    int slot = first;

    chunk_reserve_contacts(s, first + v->n, first);
    for (int i = s->begin; i < s->end; i++)
        for (int q = v->start[i - s->begin]; q < v->start[i - s->begin + 1];
             q++) {
            const struct row_place *const x = &b->chosen[i];
            c->owner[slot] = i;
            c->list_index[slot] = q;
            slot += box_domain_gap(&b->box, v->partner[q], x->x) < x->R;
        }
    return slot;
}

/* Completes the contacts first ... last - 1 of list v. Those of before from
 * `at` to end - 1 are in the same order: a pair that was one of them keeps its
 * history. */
static void complete_contacts(struct chunk *s, const struct neighbour_list *v,
                              int first, int last,
                              const struct chunk_contacts *old, int at, int end)
{
    struct chunk_contacts *const c = &s->contacts;

    for (int slot = first; slot < last; slot++) {
        const int q = c->list_index[slot];
        while (at < end && old->list_index[at] < q)
            at++;
        const int had = at < end && old->list_index[at] == q;
        c->partner[slot] = v->partner[q];
        for (int k = 0; k < 3; k++) {
            c->xi[k][slot] = had ? old->xi[k][at] : 0.0;
            if (s->has_rolling)
                c->roll_angle[k][slot] = had ? old->roll_angle[k][at] : 0.0;
        }
    }
}

void chunk_choose_contacts(struct chunk *s, const struct rows *b)
{
    struct chunk_contacts *const c = &s->contacts;
    const struct chunk_contacts old = set_aside(s);
    const int pairs = choose_pairs(s, b), all = choose_walls(s, b, pairs);

    complete_contacts(s, &s->pairs, 0, pairs, &old, 0, old.n_pairs);
    complete_contacts(s, &s->walls, pairs, all, &old, old.n_pairs,
                      old.n_pairs + old.n_walls);
    c->n_pairs = pairs;
    c->n_walls = all - pairs;
    chunk_split(s, b->n, s->blocks);
}
