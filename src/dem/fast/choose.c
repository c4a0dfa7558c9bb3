/* SPDX-License-Identifier: GPL-3.0-or-later */
/* choose.c -- the contacts of a chunk, chosen from its lists.
 * Chapter "Neighbours". */
#include <math.h>
#include <string.h>

#include "dem/fast/chunk.h"

/* Pairs whose distances are computed together. */
enum { NEAR_LANES = 64 };

/* Moves the contacts to the end of as many slots as the lists have pairs;
 * returns the first of theirs. The new ones are written from slot 0 on: they
 * cannot reach an old one that is still to come, which is a pair of the list
 * that is still to come. */
static int move_to_end(struct chunk *s)
{
    struct chunk_contacts *const c = &s->contacts;
    const int n = c->n_pairs + c->n_walls;
    const int first = s->pairs.n + s->walls.n - n;
    const size_t size = (size_t)n * sizeof(double);

    if (n == 0) return first;
    memmove(c->list_index + first, c->list_index, (size_t)n * sizeof(int));
    for (int k = 0; k < 3; k++) {
        memmove(c->xi[k] + first, c->xi[k], size);
        if (s->has_rolling)
            memmove(c->roll_angle[k] + first, c->roll_angle[k], size);
    }
    return first;
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

/* Writes the list indices of the near pairs as owners from slot `first` on;
 * returns the slot after the last. Writes every pair, and advances the slot
 * only for near ones, which avoids a branch. */
static int choose_pairs(struct chunk *s, const struct rows *b, int first)
{
    const int *const around = b->box.periodic;
    const int periodic = around[0] || around[1] || around[2];
    const struct neighbour_list *const v = &s->pairs;
    int *const to = s->contacts.owner; /* for now */
    int near[NEAR_LANES], slot = first;

    for (int q = 0; q < v->n; q += NEAR_LANES) {
        const int count = v->n - q < NEAR_LANES ? v->n - q : NEAR_LANES;
        if (periodic)
            find_near(b, v->owner + q, v->partner + q, count, 1, near);
        else
            find_near(b, v->owner + q, v->partner + q, count, 0, near);
        for (int p = 0; p < count; p++) {
            to[slot] = q + p;
            slot += near[p];
        }
    }
    return slot;
}

static int choose_walls(struct chunk *s, const struct rows *b, int first)
{
    const struct neighbour_list *const v = &s->walls;
    int slot = first;

    for (int q = 0; q < v->n; q++) {
        const struct row_place *const x = &b->chosen[v->owner[q]];
        s->contacts.owner[slot] = q;
        slot += box_domain_gap(&b->box, v->partner[q], x->x) < x->R;
    }
    return slot;
}

static inline void take_history(double *const component[3], int to, int from,
                                int had)
{
    for (int k = 0; k < 3; k++)
        component[k][to] = had ? component[k][from] : 0.0;
}

/* Completes the contacts first ... last - 1 of list v. The `n_old` contacts
 * from slot `old` on are those before, in the same order: a pair that was one
 * of them keeps its history. */
static void complete_contacts(struct chunk *s, const struct neighbour_list *v,
                              int first, int last, int old, int n_old)
{
    struct chunk_contacts *const c = &s->contacts;
    const int end = old + n_old;

    for (int slot = first; slot < last; slot++) {
        const int q = c->owner[slot];
        while (old < end && c->list_index[old] < q)
            old++;
        const int had = old < end && c->list_index[old] == q;
        c->list_index[slot] = q;
        c->owner[slot] = v->owner[q];
        c->partner[slot] = v->partner[q];
        take_history(c->xi, slot, old, had);
        if (s->has_rolling) take_history(c->roll_angle, slot, old, had);
    }
}

void chunk_choose_contacts(struct chunk *s, const struct rows *b)
{
    struct chunk_contacts *const c = &s->contacts;
    const int old = move_to_end(s);
    const int pairs = choose_pairs(s, b, 0), all = choose_walls(s, b, pairs);

    complete_contacts(s, &s->pairs, 0, pairs, old, c->n_pairs);
    complete_contacts(s, &s->walls, pairs, all, old + c->n_pairs, c->n_walls);
    c->n_pairs = pairs;
    c->n_walls = all - pairs;
    chunk_set_blocks(s, b->n);
}
