/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/neighbours.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"

void neighbours_watch(struct neighbours *nb, double overlap)
{
    for (int s = 0; s < nb->count; s++)
        nb->strips[s].deep =
            (struct strip_deep){.overlap = overlap, .id = -1, .other = -1};
}

struct neighbours *neighbours_create(struct particles *ps,
                                     const struct domain *box)
{
    struct neighbours *const nb = alloc_zeroed(1, sizeof *nb);

    nb->ps = ps;
    nb->bodies = bodies_create(ps->capacity, box);
    nb->grid = grid_create(ps->capacity, box);
    nb->count = strip_count(ps->capacity);
    nb->strips = alloc_zeroed((size_t)nb->count, sizeof *nb->strips);
    neighbours_watch(nb, HUGE_VAL);
    nb->barrier = barrier_create();
    nb->rank = alloc_ints(ps->capacity);
    nb->stale = 1;
    return nb;
}

void neighbours_keep_rolling(struct neighbours *nb)
{
    for (int s = 0; s < nb->count; s++)
        nb->strips[s].rolls = 1;
}

void neighbours_free(struct neighbours *nb)
{
    if (nb == NULL) return;
    for (int s = 0; s < nb->count; s++)
        strip_release(&nb->strips[s]);
    free(nb->strips);
    bodies_free(nb->bodies);
    grid_free(nb->grid);
    surfaces_free(nb->surfaces);
    driven_free(nb->drive);
    barrier_free(nb->barrier);
    free(nb->rank);
    free(nb);
}

struct neighbours_share neighbours_share(const struct neighbours *nb)
{
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();

    return (struct neighbours_share){nb->count * thread / threads,
                                     nb->count * (thread + 1) / threads};
}

/* To move a particle costs as much as two contacts. */
static long work_of(const struct strip *s)
{
    return s->contacts.n_pairs + s->contacts.n_walls + 2 * (s->end - s->begin);
}

/* Contacts lie close where a bed is dense, at the bottom or in a plug. A strip
 * belongs to whom the middle of its work belongs. (Surfaces move with the
 * strips of neighbours_share, and nobody meets before they act.) */
struct neighbours_share neighbours_work(const struct neighbours *nb)
{
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    struct neighbours_share mine = {0, 0};
    long all = 0, before = 0;

    for (int s = 0; s < nb->count; s++)
        all += work_of(&nb->strips[s]);
    if (all == 0 || nb->surfaces != NULL) return neighbours_share(nb);
    for (int s = 0; s < nb->count; s++) {
        const long own = work_of(&nb->strips[s]);
        const long of = (2 * before + own) * threads / (2 * all);
        mine.first += of < thread;
        mine.last += of <= thread;
        before += own;
    }
    return mine;
}

void neighbours_meet(const struct neighbours *nb)
{
    barrier_wait(nb->barrier, omp_get_num_threads());
}

/* The springs of strip s, before its particles change places. */
static void keep(struct neighbours *nb, int s)
{
    strip_keep(&nb->strips[s]);
    if (nb->surfaces != NULL) surfaces_keep(nb->surfaces, s, nb->ps);
}

void neighbours_open(struct neighbours *nb)
{
    struct bodies *const b = nb->bodies;

    b->n = nb->ps->n;
    bodies_hold_back(b, nb->ps);
    b->id = nb->ps->id;
    b->material = nb->ps->material;
    for (int s = 0; s < nb->count; s++) {
        struct strip *const own = &nb->strips[s];
        own->deepest = 0.0;
        if (nb->stale) {
            if (!nb->recalled) keep(nb, s);
            strip_cut(own, s, nb->count, b->n);
        }
    }
    if (nb->surfaces != NULL) surfaces_open(nb->surfaces);
    nb->recalled = 0;
    if (nb->drive != NULL) driven_index(nb->drive, nb->ps);
}

struct kept *neighbours_recall(struct neighbours *nb, int n)
{
    for (int s = 0; s < nb->count; s++)
        strip_reserve_kept(&nb->strips[s], s == 0 ? n : 0);
    nb->stale = nb->recalled = 1;
    return nb->strips[0].kept;
}

const struct kept *neighbours_keep(struct neighbours *nb, int *n)
{
    struct strip *const all = &nb->strips[0];

    *n = 0;
    for (int s = 0; s < nb->count; s++) {
        if (!nb->recalled) strip_keep(&nb->strips[s]);
        *n += nb->strips[s].n_kept;
    }
    int at = all->n_kept;
    strip_reserve_kept(all, *n);
    for (int s = 1; s < nb->count; s++)
        for (int q = 0; q < nb->strips[s].n_kept; q++)
            all->kept[at++] = nb->strips[s].kept[q];
    return all->kept;
}

void neighbours_fetch(struct neighbours *nb)
{
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++)
        bodies_fetch(nb->bodies, nb->ps, nb->strips[s].begin,
                     nb->strips[s].end);
}

void neighbours_park(struct neighbours *nb)
{
    const struct neighbours_share mine = neighbours_share(nb);
    struct particles *const ps = nb->ps;

    for (int s = mine.first; s < mine.last; s++) {
        const struct strip *const own = &nb->strips[s];
        bodies_park(nb->bodies, ps, own->begin, own->end);
        if (nb->stale) continue; /* no step was made */
        for (int i = own->begin; i < own->end; i++) {
            ps->cfx[i] = own->load[i - own->begin][0];
            ps->cfy[i] = own->load[i - own->begin][1];
            ps->cfz[i] = own->load[i - own->begin][2];
        }
    }
}

/* The bound is by component: no square root a particle. */
double neighbours_speed(const struct neighbours *nb)
{
    double top[3] = {0.0, 0.0, 0.0};

    for (int s = 0; s < nb->count; s++)
        for (int k = 0; k < 3; k++)
            top[k] = fmax(top[k], nb->strips[s].fastest[k]);
    const double v = sqrt(top[0] * top[0] + top[1] * top[1] + top[2] * top[2]);
    return nb->surfaces != NULL ? fmax(v, nb->surfaces->speed) : v;
}

void neighbours_look(struct neighbours *nb)
{
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        own->survey = bodies_look(nb->bodies, own->begin, own->end);
        if (nb->surfaces != NULL)
            surfaces_look(nb->surfaces, s, own, nb->bodies, !nb->stale,
                          nb->skin, &own->survey);
    }
}

/* Farthest that anybody moved since the vicinity was made [m], or -1. */
static double farthest(const struct neighbours *nb)
{
    double moved2 = 0.0, walls = 0.0;

    for (int s = 0; s < nb->count; s++) {
        if (nb->strips[s].survey.lost > 0) return -1.0;
        moved2 = fmax(moved2, nb->strips[s].survey.moved2);
        if (nb->surfaces != NULL)
            walls = fmax(walls, surfaces_moved(nb->surfaces, s));
    }
    return fmax(sqrt(moved2), walls);
}

/* By one thread: the particles in their new order, and the new place of
 * each. */
static void sort(struct neighbours *nb)
{
    const struct particles *const ps = nb->ps;
    double widest = 0.0;

    for (int i = 0; i < ps->n; i++)
        widest = fmax(widest, ps->d[i]);
    const int *const order =
        grid_order(nb->grid, ps, widest + nb->skin + nb->range);
    particles_permute(nb->ps, order);
    for (int i = 0; i < ps->n; i++)
        nb->rank[order[i]] = i;
    if (nb->surfaces != NULL) surfaces_index(nb->surfaces, ps);
    if (nb->drive != NULL) driven_index(nb->drive, ps);
    nb->rebuilds++;
}

/* The strip of particle i: its begin is n s / count, rounded down. */
static struct strip *strip_of(const struct neighbours *nb, int i)
{
    const long s = ((i + 1L) * nb->count - 1) / nb->bodies->n;
    return &nb->strips[s];
}

/* Gives a spring back to its pair, under the new numbers. If the other of the
 * two owns it now, n points the other way, and so does xi. */
static void restore(struct neighbours *nb, const struct kept *old)
{
    struct kept k = *old;

    k.owner = nb->rank[old->owner];
    if (old->partner >= 0) {
        k.partner = nb->rank[old->partner];
        if (!grid_owns(nb->grid, k.owner, k.partner, nb->bodies->n)) {
            const int swap = k.owner;
            k.owner = k.partner;
            k.partner = swap;
            for (int a = 0; a < 3; a++) {
                k.spring[a] = -k.spring[a];
                k.roll[a] = -k.roll[a];
            }
        }
    }
    strip_restore(strip_of(nb, k.owner), &k);
}

static void rebuild(struct neighbours *nb)
{
    const struct neighbours_share mine = neighbours_share(nb);
    struct bodies *const b = nb->bodies;

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        if (!nb->stale) keep(nb, s);
        bodies_park(b, nb->ps, own->begin, own->end);
    }
    neighbours_meet(nb);
    if (mine.first == 0) sort(nb);
    neighbours_meet(nb);
    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        bodies_fetch(b, nb->ps, own->begin, own->end);
        if (nb->drive != NULL)
            driven_weigh(nb->drive, b, nb->ps, own->begin, own->end);
        bodies_mark(b, own->begin, own->end);
    }
    neighbours_meet(nb);
    for (int s = mine.first; s < mine.last; s++) {
        grid_find(nb->grid, &nb->strips[s], b, nb->skin + nb->range);
        if (nb->surfaces != NULL)
            surfaces_find(nb->surfaces, s, &nb->strips[s], b, nb->skin);
    }
    neighbours_meet(nb);
    for (int s = mine.first; s < mine.last; s++)
        for (int q = 0; q < nb->strips[s].n_kept; q++)
            restore(nb, &nb->strips[s].kept[q]);
    neighbours_meet(nb);
    if (mine.first == 0) nb->stale = 0;
}

double neighbours_refresh(struct neighbours *nb, double wanted)
{
    const struct neighbours_share mine = neighbours_share(nb);
    const double margin = nb->fresh ? 0.0 : fmin(wanted, 0.25 * nb->skin);

    neighbours_look(nb);
    neighbours_meet(nb);
    const double moved = farthest(nb);
    neighbours_meet(nb);
    if (moved < 0.0) return -1.0;
    if (nb->stale || nb->fresh || nb->skin - 2.0 * moved < margin) rebuild(nb);
    for (int s = mine.first; s < mine.last; s++) {
        strip_choose(&nb->strips[s], nb->bodies, margin);
        if (nb->surfaces != NULL)
            surfaces_choose(nb->surfaces, s, nb->bodies, margin);
    }
    neighbours_meet(nb);
    return margin;
}
