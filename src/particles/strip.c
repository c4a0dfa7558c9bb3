/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/strip.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "particles/strip_gap.h"

/* Strips of at least STRIP_LEAST particles, so that what a strip lays on the
 * next ones stays a small part of its work; a power of two, which most
 * machines can share out evenly. The contact loop takes STRIP_LANES contacts
 * at a time (contact_sweep.h): so many slots are kept free after the last, and
 * a block ends where these end. */
enum {
    STRIP_LEAST = 1000,
    STRIP_MOST = 64,
    STRIP_BLOCK = 512,
    STRIP_LANES = 64
};

int strip_count(int n)
{
    int count = 1;

    while (count < STRIP_MOST && 2 * count * STRIP_LEAST <= n)
        count *= 2;
    return count;
}

void strip_release(struct strip *s)
{
    struct vicinity *const lists[] = {&s->pairs, &s->walls};

    for (int l = 0; l < 2; l++) {
        free(lists[l]->start);
        free(lists[l]->partner);
        free(lists[l]->spring);
        free(lists[l]->roll);
    }
    for (int k = 0; k < 3; k++) {
        free(s->contacts.spring[k]);
        free(s->contacts.roll[k]);
    }
    free(s->contacts.owner);
    free(s->contacts.partner);
    free(s->contacts.source);
    free(s->load);
    free(s->blocks);
    free(s->kept);
}

/* A larger array with the `used` first items of the old one, which is freed. */
static void *grown(void *old, int used, int capacity, size_t size)
{
    void *const larger = alloc_zeroed((size_t)capacity, size);

    if (used > 0) memcpy(larger, old, (size_t)used * size);
    free(old);
    return larger;
}

/* Half as much again as is needed: growing ends after a few rebuilds. */
static int roomy(int needed)
{
    return needed + needed / 2 + 64;
}

void strip_cut(struct strip *s, int number, int count, int n)
{
    const int had = s->end - s->begin;

    s->begin = (int)((long)n * number / count);
    s->end = (int)((long)n * (number + 1) / count);
    s->n_blocks = (s->end - s->begin + STRIP_BLOCK - 1) / STRIP_BLOCK;
    if (s->pairs.start != NULL && s->end - s->begin <= had) return;
    free(s->blocks);
    s->blocks = alloc_zeroed((size_t)s->n_blocks, sizeof *s->blocks);
    for (int l = 0; l < 2; l++) {
        struct vicinity *const v = l == 0 ? &s->pairs : &s->walls;
        free(v->start);
        v->start = alloc_ints(s->end - s->begin + 1);
    }
}

void strip_clear(struct strip *s)
{
    s->pairs.n = s->walls.n = 0;
    s->window = s->end - s->begin;
}

void strip_begin_owner(struct strip *s, int i)
{
    s->pairs.start[i - s->begin] = s->pairs.n;
    s->walls.start[i - s->begin] = s->walls.n;
}

static void vicinity_add(struct vicinity *v, int n, const int *partner,
                         int rolls)
{
    if (n == 0) return;
    if (v->n + n > v->capacity) {
        v->capacity = roomy(v->n + n);
        v->partner = grown(v->partner, v->n, v->capacity, sizeof *v->partner);
        v->spring = grown(v->spring, v->n, v->capacity, sizeof *v->spring);
        if (rolls) v->roll = grown(v->roll, v->n, v->capacity, sizeof *v->roll);
    }
    memset(v->spring[v->n], 0, (size_t)n * sizeof *v->spring);
    if (rolls) memset(v->roll[v->n], 0, (size_t)n * sizeof *v->roll);
    memcpy(&v->partner[v->n], partner, (size_t)n * sizeof *partner);
    v->n += n;
}

void strip_add_pairs(struct strip *s, int n, const int *partner)
{
    vicinity_add(&s->pairs, n, partner, s->rolls);
}

void strip_add_wall(struct strip *s, int wall)
{
    vicinity_add(&s->walls, 1, &wall, s->rolls);
}

/* The load of particle j among those of the strip; an index before the strip's
 * first stands for one after the last of all n (periodic, slowest direction).
 */
static int load_of(const struct strip *s, int j, int n)
{
    return j < s->begin ? j - s->begin + n : j - s->begin;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* The loads reach as far as the farthest partner after the strip's first. */
void strip_close(struct strip *s, int n)
{
    struct contacts *const c = &s->contacts;
    const int most = s->pairs.n + s->walls.n + STRIP_LANES;

    strip_begin_owner(s, s->end);
    for (int q = 0; q < s->pairs.n; q++)
        s->window = larger(s->window, load_of(s, s->pairs.partner[q], n) + 1);
    if (s->load == NULL || s->window > s->load_capacity) {
        free(s->load);
        s->load_capacity = roomy(s->window);
        s->load = alloc_zeroed((size_t)s->load_capacity, sizeof *s->load);
    }
    c->n_pairs = c->n_walls = 0;
    if (most <= c->capacity) return;
    c->capacity = roomy(most);
    c->owner = grown(c->owner, 0, c->capacity, sizeof *c->owner);
    c->partner = grown(c->partner, 0, c->capacity, sizeof *c->partner);
    c->source = grown(c->source, 0, c->capacity, sizeof *c->source);
    for (int k = 0; k < 3; k++) {
        c->spring[k] = grown(c->spring[k], 0, c->capacity, sizeof(double));
        if (s->rolls)
            c->roll[k] = grown(c->roll[k], 0, c->capacity, sizeof(double));
    }
}

static void springs_home(struct strip *s)
{
    const struct contacts *const c = &s->contacts;

    for (int q = 0; q < c->n_pairs + c->n_walls; q++) {
        struct vicinity *const v = q < c->n_pairs ? &s->pairs : &s->walls;
        for (int k = 0; k < 3; k++)
            v->spring[c->source[q]][k] = c->spring[k][q];
        for (int k = 0; s->rolls && k < 3; k++)
            v->roll[c->source[q]][k] = c->roll[k][q];
    }
}

/* The spring of place q in the vicinity goes to a slot of the contacts. */
static inline void move_spring(struct contacts *c, struct vicinity *v, int slot,
                               int q, int rolls)
{
    for (int k = 0; k < 3; k++) {
        c->spring[k][slot] = v->spring[q][k];
        v->spring[q][k] = 0.0;
    }
    for (int k = 0; rolls && k < 3; k++) {
        c->roll[k][slot] = v->roll[q][k];
        v->roll[q][k] = 0.0;
    }
}

/* Writes every pair and keeps the near ones by moving on: no branch to guess.
 * Who is not chosen has parted, and its spring is gone. */
static inline void choose(struct strip *s, const struct bodies *b,
                          struct vicinity *v,
                          double (*gap)(const struct bodies *, int, int),
                          double margin, int *n, int rolls)
{
    struct contacts *const c = &s->contacts;
    int slot = *n;

    for (int i = s->begin; i < s->end; i++)
        for (int q = v->start[i - s->begin]; q < v->start[i - s->begin + 1];
             q++) {
            const int j = v->partner[q], near = gap(b, i, j) < margin;
            c->owner[slot] = i;
            c->partner[slot] = j;
            c->source[slot] = q;
            move_spring(c, v, slot, q, rolls);
            slot += near;
        }
    *n = slot;
}

/* Of the contacts first ... last - 1, where those of the owners before `end`
 * end, and so many more that no lane of the contact loop is empty. */
static int full_lanes(const struct contacts *c, int first, int from, int last,
                      int end)
{
    while (from < last && c->owner[from] < end)
        from++;
    const int lanes = (from - first + STRIP_LANES - 1) / STRIP_LANES;
    const int full = first + lanes * STRIP_LANES;
    return full < last ? full : last;
}

static void divide(struct strip *s, int n)
{
    const struct contacts *const c = &s->contacts;
    struct block at = {s->begin, 0, c->n_pairs, 0};

    for (int k = 0; k < s->n_blocks; k++) {
        int q = at.pairs;
        at.end = k + 1 < s->n_blocks ? at.end + STRIP_BLOCK : s->end;
        at.pairs = full_lanes(c, 0, q, c->n_pairs, at.end);
        at.walls = full_lanes(c, c->n_pairs, at.walls, c->n_pairs + c->n_walls,
                              at.end);
        at.reach = larger(at.reach, at.end - s->begin);
        if (at.walls > c->n_pairs)
            at.reach = larger(at.reach, c->owner[at.walls - 1] - s->begin + 1);
        for (; q < at.pairs; q++) { /* round a period a partner comes first */
            const int last = larger(load_of(s, c->partner[q], n),
                                    load_of(s, c->owner[q], n));
            at.reach = larger(at.reach, last + 1);
        }
        if (k + 1 == s->n_blocks) at.reach = s->window;
        s->blocks[k] = at;
    }
}

void strip_choose(struct strip *s, const struct bodies *b, double margin)
{
    int n = 0;

    springs_home(s);
    if (s->rolls)
        choose(s, b, &s->pairs, strip_pair_gap, margin, &n, 1);
    else
        choose(s, b, &s->pairs, strip_pair_gap, margin, &n, 0);
    s->contacts.n_pairs = n;
    choose(s, b, &s->walls, strip_wall_gap, margin, &n, s->rolls);
    s->contacts.n_walls = n - s->contacts.n_pairs;
    divide(s, b->n);
}

void strip_reserve_kept(struct strip *s, int n)
{
    if (n > s->kept_capacity) {
        s->kept_capacity = roomy(n);
        s->kept = grown(s->kept, s->n_kept, s->kept_capacity, sizeof *s->kept);
    }
    s->n_kept = n;
}

static int is_zero(double *const component[3], int q)
{
    return component[0][q] == 0.0 && component[1][q] == 0.0 &&
           component[2][q] == 0.0;
}

/* A pair that touches has drawn its springs, if ever so little; a pair whose
 * springs are 0 has nothing to remember. */
void strip_keep(struct strip *s)
{
    const struct contacts *const c = &s->contacts;
    const int n = c->n_pairs + c->n_walls;

    s->n_kept = 0;
    strip_reserve_kept(s, n);
    s->n_kept = 0;
    for (int q = 0; q < n; q++) {
        if (is_zero(c->spring, q) && (!s->rolls || is_zero(c->roll, q)))
            continue;
        struct kept *const k = &s->kept[s->n_kept++];
        *k = (struct kept){
            .owner = c->owner[q],
            .partner = q < c->n_pairs ? c->partner[q] : -1 - c->partner[q],
            .spring = {c->spring[0][q], c->spring[1][q], c->spring[2][q]},
        };
        for (int a = 0; s->rolls && a < 3; a++)
            k->roll[a] = c->roll[a][q];
    }
}

void strip_restore(struct strip *s, const struct kept *k)
{
    struct vicinity *const v = k->partner < 0 ? &s->walls : &s->pairs;
    const int partner = k->partner < 0 ? -1 - k->partner : k->partner;
    const int a = k->owner - s->begin;
    int q = v->start[a];

    while (q < v->start[a + 1] && v->partner[q] != partner)
        q++;
    if (q == v->start[a + 1]) return; /* they have parted since */
    memcpy(v->spring[q], k->spring, sizeof k->spring);
    if (s->rolls) memcpy(v->roll[q], k->roll, sizeof k->roll);
}

int strip_reached(const struct strip *s, const struct strip *t, int n)
{
    const int size = s->end - s->begin;

    if (size == 0) return 0;
    const int reached = t->window - (s->begin - t->begin + n) % n;
    return reached < 0 ? 0 : reached < size ? reached : size;
}

void strip_fold(struct strip *strips, int count, int s, int n, int begin,
                int end)
{
    struct strip *const own = &strips[s];

    for (int back = 1; back < count; back++) {
        const struct strip *const t = &strips[(s - back + count) % count];
        const int offset = (own->begin - t->begin + n) % n;
        const int last = own->begin + strip_reached(own, t, n);
        for (int i = begin; i < (end < last ? end : last); i++)
            for (int k = 0; k < 8; k++)
                own->load[i - own->begin][k] +=
                    t->load[i - own->begin + offset][k];
    }
}

static int touching(const struct strip *s, const struct bodies *b)
{
    const struct contacts *const c = &s->contacts;
    int n = 0;

    for (int q = 0; q < c->n_pairs + c->n_walls; q++)
        n += (q < c->n_pairs ? strip_pair_gap : strip_wall_gap)(
                 b, c->owner[q], c->partner[q]) < 0.0;
    return n;
}

void strip_measure(struct strip *s, const struct bodies *b)
{
    struct strip_measures *const m = &s->measures;

    *m = (struct strip_measures){touching(s, b), 0.0, 0.0, 0.0};
    for (int i = s->begin; i < s->end; i++) {
        const double *const v = b->motion[i];
        const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const double s2 = v[4] * v[4] + v[5] * v[5] + v[6] * v[6];

        m->translation += 0.5 * v2 / v[7];
        m->rotation += 0.2 * s2 / v[7]; /* I = (2/5) m R^2 */
        m->speed2 = v2 > m->speed2 ? v2 : m->speed2;
    }
}
