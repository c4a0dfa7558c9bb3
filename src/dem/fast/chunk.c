/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/chunk.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/fast/sweep.h"

/* A chunk has at least CHUNK_LEAST particles, so that the loads on the
 * following chunks are a small part of its work; the number of chunks is a
 * power of two, which divides evenly among the threads of most machines. As
 * many slots as the contact loop has lanes (sweep.h) are kept free after the
 * last contact, and a block ends at a multiple of them. */
enum { CHUNK_LEAST = 1000, CHUNK_MOST = 64 };

int chunk_count(int n)
{
    int count = 1;

    while (count < CHUNK_MOST && 2 * count * CHUNK_LEAST <= n)
        count *= 2;
    return count;
}

void chunk_release(struct chunk *s)
{
    struct chunk_contacts *const c = &s->contacts;
    void *const all[] = {s->pairs.start,   s->pairs.partner, s->walls.start,
                         s->walls.partner, c->owner,         c->partner,
                         c->list_index,    c->xi[0],         c->xi[1],
                         c->xi[2],         c->roll_angle[0], c->roll_angle[1],
                         c->roll_angle[2], s->load,          s->part,
                         s->blocks,        s->roll_history};

    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        free(all[k]);
}

/* A sixteenth more than needed, so that arrays seldom grow after a few
 * rebuilds. */
static int roomy(int needed)
{
    return needed + needed / 16 + 64;
}

void chunk_set_range(struct chunk *s, int number, int count, int n)
{
    const int had = s->end - s->begin;

    s->begin = (int)((long)n * number / count);
    s->end = (int)((long)n * (number + 1) / count);
    s->n_blocks = (s->end - s->begin + CHUNK_BLOCK - 1) / CHUNK_BLOCK;
    if (s->pairs.start != NULL && s->end - s->begin <= had) return;
    free(s->blocks);
    s->blocks = alloc_zeroed((size_t)s->n_blocks, sizeof *s->blocks);
    for (int l = 0; l < 2; l++) {
        struct neighbour_list *const v = l == 0 ? &s->pairs : &s->walls;
        free(v->start);
        v->start = alloc_ints(s->end - s->begin + 1);
    }
}

void chunk_clear_lists(struct chunk *s)
{
    s->pairs.n = s->walls.n = 0;
    s->window = s->end - s->begin;
}

void chunk_begin_owner(struct chunk *s, int i)
{
    s->pairs.start[i - s->begin] = s->pairs.n;
    s->walls.start[i - s->begin] = s->walls.n;
}

static int *list_room_for(struct neighbour_list *v, int n)
{
    if (v->n + n > v->capacity) {
        v->capacity = roomy(v->n + n);
        v->partner =
            alloc_grown(v->partner, v->n, v->capacity, sizeof *v->partner);
    }
    return v->partner + v->n;
}

int *chunk_room_for_pairs(struct chunk *s, int n)
{
    return list_room_for(&s->pairs, n);
}

void chunk_add_wall(struct chunk *s, int wall)
{
    *list_room_for(&s->walls, 1) = wall;
    s->walls.n++;
}

/* The load of particle j among those of the chunk; an index before the chunk's
 * first stands for one after the last of all n (periodic, slowest direction).
 */
static int load_of(const struct chunk *s, int j, int n)
{
    return j < s->begin ? j - s->begin + n : j - s->begin;
}

static int chunk_larger(int a, int b)
{
    return a > b ? a : b;
}

void chunk_reserve_loads(struct chunk *s, size_t bytes, size_t used)
{
    const size_t row = sizeof *s->load;
    const int needed = (int)((bytes + row - 1) / row);

    if (needed > s->load_capacity) {
        s->load_capacity = roomy(needed);
        s->load = alloc_grown(s->load, (int)((used + row - 1) / row),
                              s->load_capacity, row);
        free(s->part);
        s->part = NULL;
    }
    if (s->has_budget && s->part == NULL)
        s->part = alloc_zeroed((size_t)s->load_capacity, sizeof *s->part);
    chunk_begin_loads(s, NULL, 0);
}

void chunk_reserve_contacts(struct chunk *s, int n, int used)
{
    struct chunk_contacts *const c = &s->contacts;

    if (n + SWEEP_LANES <= c->capacity) return;
    c->capacity = roomy(n + SWEEP_LANES);
    c->owner = alloc_grown(c->owner, used, c->capacity, sizeof *c->owner);
    c->partner = alloc_grown(c->partner, 0, c->capacity, sizeof *c->partner);
    c->list_index =
        alloc_grown(c->list_index, used, c->capacity, sizeof *c->list_index);
    for (int k = 0; k < 3; k++) {
        c->xi[k] = alloc_grown(c->xi[k], 0, c->capacity, sizeof(double));
        if (s->has_rolling)
            c->roll_angle[k] =
                alloc_grown(c->roll_angle[k], 0, c->capacity, sizeof(double));
    }
}

/* The loads extend to the farthest partner after the first particle of the
 * chunk. */
void chunk_finish_lists(struct chunk *s, int n)
{
    chunk_begin_owner(s, s->end);
    for (int q = 0; q < s->pairs.n; q++)
        s->window =
            chunk_larger(s->window, load_of(s, s->pairs.partner[q], n) + 1);
    chunk_reserve_loads(s, (size_t)s->window * sizeof *s->load,
                        (size_t)s->n_history * sizeof *chunk_history(s));
    s->contacts.n_pairs = s->contacts.n_walls = 0;
    chunk_reserve_contacts(s, s->pairs.n / 4, 0);
}

/* The contacts first ... last - 1 are in the order of their owners. Returns the
 * end of those whose owners are before `end`, rounded up to a whole number of
 * lanes of the contact loop; the search begins at `from`. */
static int full_lanes(const struct chunk_contacts *c, int first, int from,
                      int last, int end)
{
    while (from < last && c->owner[from] < end)
        from++;
    const int lanes = (from - first + SWEEP_LANES - 1) / SWEEP_LANES;
    const int full = first + lanes * SWEEP_LANES;
    return full < last ? full : last;
}

void chunk_split(const struct chunk *s, int n, struct chunk_block *blocks)
{
    const struct chunk_contacts *const c = &s->contacts;
    struct chunk_block at = {s->begin, 0, c->n_pairs, 0};

    for (int k = 0; k < s->n_blocks; k++) {
        int q = at.pairs;
        at.end = k + 1 < s->n_blocks ? at.end + CHUNK_BLOCK : s->end;
        at.pairs = full_lanes(c, 0, q, c->n_pairs, at.end);
        at.walls = full_lanes(c, c->n_pairs, at.walls, c->n_pairs + c->n_walls,
                              at.end);
        at.n_loads = chunk_larger(at.n_loads, at.end - s->begin);
        if (at.walls > c->n_pairs)
            at.n_loads =
                chunk_larger(at.n_loads, c->owner[at.walls - 1] - s->begin + 1);
        for (; q < at.pairs; q++) { /* a partner may have a lower index */
            const int last = chunk_larger(load_of(s, c->partner[q], n),
                                          load_of(s, c->owner[q], n));
            at.n_loads = chunk_larger(at.n_loads, last + 1);
        }
        if (k + 1 == s->n_blocks) at.n_loads = s->window;
        blocks[k] = at;
    }
}

void chunk_reserve_history(struct chunk *s, int n)
{
    const size_t size = sizeof *chunk_history(s);

    chunk_reserve_loads(s, (size_t)n * size, (size_t)s->n_history * size);
    if (s->has_rolling && n > s->n_history)
        s->roll_history = alloc_grown(s->roll_history, s->n_history, n,
                                      sizeof *s->roll_history);
    s->n_history = n;
}

static int is_zero(double *const component[3], int q)
{
    return component[0][q] == 0.0 && component[1][q] == 0.0 &&
           component[2][q] == 0.0;
}

static int has_history(const struct chunk *s, int q)
{
    const struct chunk_contacts *const c = &s->contacts;

    return !is_zero(c->xi, q) || (s->has_rolling && !is_zero(c->roll_angle, q));
}

/* The tangential displacement of a touching pair is never exactly 0; a pair
 * with 0 has no history. */
int chunk_contact_history(const struct chunk *s, int q,
                          struct contact_history *k, double roll[3])
{
    const struct chunk_contacts *const c = &s->contacts;
    const int partner = c->partner[q];

    if (!has_history(s, q)) return 0;
    k->owner = c->owner[q];
    k->partner = q < c->n_pairs ? partner : -1 - partner;
    for (int a = 0; a < 3; a++) {
        k->xi[a] = c->xi[a][q];
        if (s->has_rolling) roll[a] = c->roll_angle[a][q];
    }
    return 1;
}

void chunk_save_history(struct chunk *s)
{
    const int all = s->contacts.n_pairs + s->contacts.n_walls;
    struct contact_history one;
    double roll[3];
    int n = 0;

    for (int q = 0; q < all; q++)
        n += has_history(s, q);
    s->n_history = 0;
    chunk_reserve_history(s, n);
    for (int q = 0, at = 0; q < all; q++) {
        if (!chunk_contact_history(s, q, &one, roll)) continue;
        chunk_history(s)[at] = one;
        if (s->has_rolling) memcpy(s->roll_history[at], roll, sizeof roll);
        at++;
    }
}

/* The first of the contacts first ... last - 1 whose owner is not before i. */
static int first_of_owner(const struct chunk_contacts *c, int first, int last,
                          int i)
{
    while (first < last) {
        const int middle = first + (last - first) / 2;
        if (c->owner[middle] < i)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

void chunk_restore_history(struct chunk *s, const struct contact_history *k,
                           const double *roll)
{
    struct chunk_contacts *const c = &s->contacts;
    const int wall = k->partner < 0, all = c->n_pairs + c->n_walls;
    const int partner = wall ? -1 - k->partner : k->partner;
    const int last = wall ? all : c->n_pairs;
    int q = first_of_owner(c, wall ? c->n_pairs : 0, last, k->owner);

    while (q < last && c->owner[q] == k->owner && c->partner[q] != partner)
        q++;
    if (q == last || c->owner[q] != k->owner) return; /* they have parted */
    for (int a = 0; a < 3; a++) {
        c->xi[a][q] = k->xi[a];
        if (roll != NULL) c->roll_angle[a][q] = roll[a];
    }
}

void chunk_measure(struct chunk *s, const struct rows *b)
{
    const struct chunk_contacts *const c = &s->contacts;
    struct chunk_measures *const m = &s->measures;

    *m = (struct chunk_measures){.contacts = 0};
    for (int q = 0; q < c->n_pairs + c->n_walls; q++)
        m->contacts +=
            (q < c->n_pairs ? rows_pair_gap(b, c->owner[q], c->partner[q])
                            : rows_wall_gap(&b->box, &b->place[c->owner[q]],
                                            c->partner[q])) < 0.0;
    for (int i = s->begin; i < s->end; i++) {
        const struct row_motion *const own = &b->motion[i];
        const double v2 = vector_dot(own->v, own->v);

        m->speed2 = v2 > m->speed2 ? v2 : m->speed2;
        if (b->ball != NULL && b->ball[i].of >= 0) continue;
        m->translation += 0.5 * v2 / own->per_m;
        m->rotation += /* I = (2/5) m R^2 */
            0.2 * vector_dot(own->s, own->s) / own->per_m;
    }
}

void chunk_record_overlap(struct dem_overlap *d, double depth, int id,
                          int other, const double x[3])
{
    if (!(depth > d->depth)) return;
    d->depth = depth;
    d->id = id;
    d->other = other;
    memcpy(d->at, x, sizeof d->at);
}

/* As in the contact loop, a wall counts as a sphere of the same radius. */
void chunk_check_overlaps(struct chunk *s, const struct rows *b,
                          const struct chunk_block *from,
                          const struct chunk_block *to)
{
    const int *const owner = s->contacts.owner;
    const int *const partner = s->contacts.partner;

    for (int q = from->pairs; q < to->pairs; q++) {
        const int i = owner[q], j = partner[q];
        const double sum = b->place[i].R + b->place[j].R;
        chunk_record_overlap(&s->deep, -rows_pair_gap(b, i, j) / sum, b->id[i],
                             b->id[j], b->place[i].x);
    }
    for (int q = from->walls; q < to->walls; q++) {
        const struct row_place *const p = &b->place[owner[q]];
        const double gap = rows_wall_gap(&b->box, p, partner[q]);
        chunk_record_overlap(&s->deep, -0.5 * gap / p->R, b->id[owner[q]],
                             -1 - partner[q], p->x);
    }
    if (s->max_overlap > s->deep.depth) s->deep.depth = s->max_overlap;
}
