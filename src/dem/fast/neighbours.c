/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/neighbours.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/dem.h"

void neighbours_watch(struct neighbours *nb, double overlap)
{
    for (int s = 0; s < nb->n_chunks; s++)
        nb->chunks[s].deep =
            (struct dem_overlap){.depth = overlap, .id = -1, .other = -1};
}

struct neighbours *neighbours_create(struct particles *ps,
                                     const struct box_domain *box)
{
    struct neighbours *const nb = owner_create(sizeof *nb);

    nb->ps = ps;
    nb->rows = rows_create(ps->capacity, box);
    nb->grid = grid_create(ps->capacity, box);
    nb->n_chunks = chunk_count(ps->capacity);
    nb->chunks = owner_zeroed(nb, (size_t)nb->n_chunks, sizeof *nb->chunks);
    neighbours_watch(nb, HUGE_VAL);
    nb->barrier = barrier_create();
    nb->rank = owner_ints(nb, ps->capacity);
    nb->stale = 1;
    return nb;
}

void neighbours_add_rolling(struct neighbours *nb)
{
    for (int s = 0; s < nb->n_chunks; s++)
        nb->chunks[s].has_rolling = 1;
}

void neighbours_free(struct neighbours *nb)
{
    if (nb == NULL) return;
    for (int s = 0; s < nb->n_chunks; s++)
        chunk_release(&nb->chunks[s]);
    owner_free(nb->rows);
    grid_free(nb->grid);
    surfaces_free(nb->surfaces);
    owner_free(nb->prescribed);
    barrier_free(nb->barrier);
    free(nb->ring);
    owner_free(nb);
}

struct chunk_range neighbours_part(int n)
{
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();

    return (struct chunk_range){n * thread / threads,
                                n * (thread + 1) / threads};
}

/* The chunks whose lists this thread makes, an equal number for each thread. */
struct chunk_range neighbours_static_range(const struct neighbours *nb)
{
    return neighbours_part(nb->n_chunks);
}

/* In a step a contact costs about twice as much as the motion of a particle. */
static long work_of(const struct chunk *s)
{
    return 2L * (s->contacts.n_pairs + s->contacts.n_walls) + s->end - s->begin;
}

/* Contacts are not distributed evenly over the chunks of a bed. Each chunk is
 * assigned by the midpoint of its cumulative cost. (With surfaces the static
 * partition is used, because there is no barrier between their motion and their
 * forces.) */
struct chunk_range neighbours_balanced_range(const struct neighbours *nb)
{
    const int thread = omp_get_thread_num(), threads = omp_get_num_threads();
    struct chunk_range mine = {0, 0};
    long all = 0, before = 0;

    for (int s = 0; s < nb->n_chunks; s++)
        all += work_of(&nb->chunks[s]);
    if (all == 0 || nb->surfaces != NULL) return neighbours_static_range(nb);
    for (int s = 0; s < nb->n_chunks; s++) {
        const long own = work_of(&nb->chunks[s]);
        const long of = (2 * before + own) * threads / (2 * all);
        mine.first += of < thread;
        mine.last += of <= thread;
        before += own;
    }
    return mine;
}

void neighbours_barrier(const struct neighbours *nb)
{
    barrier_wait(nb->barrier, omp_get_num_threads());
}

/* Saves the histories of chunk s before its particles are sorted. */
static void save_history(struct neighbours *nb, int s)
{
    chunk_save_history(&nb->chunks[s]);
    if (nb->surfaces != NULL) surfaces_save_history(nb->surfaces, s, nb->ps);
}

/* Most loads of a ring: as many as 1e7 particles need, and 4 MB. */
enum { LEAST_RING = 4096, MOST_RING = 65536 };

/* A block reaches a few layers of cells: more particles, longer chunks. */
static void add_rings(struct neighbours *nb, int team)
{
    const int longest = nb->ps->capacity / nb->n_chunks;

    nb->ring_size = LEAST_RING;
    while (nb->ring_size < longest && nb->ring_size < MOST_RING)
        nb->ring_size *= 2;
    free(nb->ring);
    nb->ring = alloc_zeroed(2 * (size_t)team * (size_t)nb->ring_size,
                            sizeof *nb->ring);
    nb->n_rings = team;
}

void neighbours_begin_run(struct neighbours *nb, int team)
{
    struct rows *const b = nb->rows;

    if (team > nb->n_rings) add_rings(nb, team);
    b->n = nb->ps->n;
    rows_add_implicit_drag(b, nb->ps);
    b->id = nb->ps->id;
    b->material = nb->ps->material;
    for (int s = 0; s < nb->n_chunks; s++) {
        struct chunk *const own = &nb->chunks[s];
        own->max_overlap = 0.0;
        own->margin_left_now = HUGE_VAL;
        if (nb->stale) {
            if (!nb->history_given) save_history(nb, s);
            chunk_set_range(own, s, nb->n_chunks, b->n);
        }
    }
    if (nb->surfaces != NULL) surfaces_begin_run(nb->surfaces);
    nb->history_given = 0;
    fast_clumps_locate(nb);
    if (nb->prescribed != NULL)
        prescribed_particles_locate(nb->prescribed, nb->ps);
}

void neighbours_load(struct neighbours *nb)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++)
        rows_load(nb->rows, nb->ps, nb->chunks[s].begin, nb->chunks[s].end);
    fast_clumps_write(nb);
}

void neighbours_store(struct neighbours *nb)
{
    const struct chunk_range mine = neighbours_static_range(nb);
    struct particles *const ps = nb->ps;

    for (int s = mine.first; s < mine.last; s++) {
        const struct chunk *const own = &nb->chunks[s];
        rows_store(nb->rows, ps, own->begin, own->end);
        if (nb->stale) continue; /* no step was made */
        for (int i = own->begin; i < own->end; i++) {
            const double *const F = own->load[i - own->begin].F;
            ps->cfx[i] = F[0], ps->cfy[i] = F[1], ps->cfz[i] = F[2];
        }
    }
}

/* The bound is computed by component, without a square root for each particle.
 */
double neighbours_speed(const struct neighbours *nb)
{
    double top[3] = {0.0, 0.0, 0.0};

    for (int s = 0; s < nb->n_chunks; s++)
        for (int k = 0; k < 3; k++)
            top[k] = fmax(top[k], nb->chunks[s].max_speed[k]);
    for (int s = 0; s < FAST_CLUMPS_SLICES && nb->clump_speed != NULL; s++)
        for (int k = 0; k < 3; k++)
            top[k] = fmax(top[k], nb->clump_speed[s][k]);
    const double v = sqrt(top[0] * top[0] + top[1] * top[1] + top[2] * top[2]);
    return nb->surfaces != NULL ? fmax(v, nb->surfaces->speed) : v;
}

void neighbours_check_lost(struct neighbours *nb)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        own->survey = rows_check_lost(nb->rows, own->begin, own->end);
        if (nb->surfaces != NULL)
            surfaces_check_lost(nb->surfaces, s, own, nb->rows, !nb->stale,
                                nb->skin, &own->survey);
    }
}

double neighbours_margin_left(const struct neighbours *nb, int found)
{
    const struct chunk_range mine = neighbours_static_range(nb);
    double left = HUGE_VAL;

    for (int s = mine.first; s < mine.last && !found; s++) {
        struct chunk *const own = &nb->chunks[s];
        own->margin_left = rows_margin_left(nb->rows, own->begin, own->end);
    }
    if (!found) neighbours_barrier(nb);
    for (int s = 0; s < nb->n_chunks; s++)
        left = fmin(left, nb->chunks[s].margin_left);
    return left < 0.0 ? -1.0 : 2.0 * left;
}

static void set_margins(const struct neighbours *nb, double least, double time)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        own->margins = rows_set_margins(nb->rows, own->begin, own->end, least,
                                        time, 0.5 * nb->skin);
    }
    neighbours_barrier(nb);
}

static int is_any_lost(const struct neighbours *nb)
{
    int lost = 0;

    for (int s = 0; s < nb->n_chunks; s++)
        lost |= nb->chunks[s].survey.lost > 0;
    return lost;
}

/* 1 if the list may end before the margins do; surfaces have the margin
 * `least` [m]. */
static int list_is_narrow(const struct neighbours *nb, double least)
{
    int narrow = nb->stale;

    for (int s = 0; s < nb->n_chunks; s++) {
        narrow |= nb->chunks[s].margins.narrow;
        if (nb->surfaces != NULL)
            narrow |= 0.5 * nb->skin - surfaces_moved(nb->surfaces, s) < least;
    }
    return narrow;
}

/* The list is made for the time when the fastest particle has moved by this
 * part of half of the skin: until then all come nearer to where they were
 * listed. */
static const double part_ahead = 0.6;

/* Called by one thread: finds the order of the particles. */
static void find_order(struct neighbours *nb)
{
    const struct particles *const ps = nb->ps;
    double widest = 0.0, v2 = 0.0;

    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        widest = fmax(widest, ps->d[i]);
        v2 = fmax(v2, vector_dot(v, v));
    }
    nb->ahead = v2 > 0.0 && nb->surfaces == NULL
                    ? part_ahead * 0.5 * nb->skin / sqrt(v2)
                    : 0.0;
    nb->order = grid_order(nb->grid, ps, widest + nb->skin + nb->range,
                           nb->ahead, nb->rank);
}

/* Called by one thread: the new index of each, and of what belongs to it. */
static void follow_order(struct neighbours *nb)
{
    const struct particles *const ps = nb->ps;

    for (int i = 0; i < ps->n; i++)
        nb->rank[nb->order[i]] = i;
    fast_clumps_locate(nb);
    if (nb->surfaces != NULL) surfaces_locate_particles(nb->surfaces, ps);
    if (nb->prescribed != NULL) prescribed_particles_locate(nb->prescribed, ps);
    nb->rebuilds++;
}

/* Restores a history with the new indices. If the other particle owns the pair
 * now, n, xi and theta change sign. */
static void restore_history(struct neighbours *nb, const struct chunk *from,
                            int q)
{
    struct contact_history k = chunk_history(from)[q];
    double roll[3] = {0.0, 0.0, 0.0};

    if (from->has_rolling) memcpy(roll, from->roll_history[q], sizeof roll);
    k.owner = nb->rank[k.owner];
    if (k.partner >= 0) {
        k.partner = nb->rank[k.partner];
        if (!grid_owns(nb->grid, k.owner, k.partner, nb->rows->n)) {
            const int swap = k.owner;
            k.owner = k.partner;
            k.partner = swap;
            for (int a = 0; a < 3; a++) {
                k.xi[a] = -k.xi[a];
                roll[a] = -roll[a];
            }
        }
    }
    chunk_restore_history(neighbours_chunk_of(nb, k.owner), &k,
                          from->has_rolling ? roll : NULL);
}

/* The motion is stored, so that its rows are free to work in. */
static void permute_by_all(struct neighbours *nb)
{
    const int threads = omp_get_num_threads(), share = omp_get_thread_num();
    const int of = threads < PARTICLES_SHARES ? threads : PARTICLES_SHARES;

    _Static_assert(sizeof *nb->rows->motion ==
                       PARTICLES_SHARES * sizeof(double),
                   "a row is the work space of a particle");
    if (share < of)
        particles_permute_share(nb->ps, nb->order, share, of,
                                (double *)nb->rows->motion);
}

/* Sorts the particles and builds all neighbour lists; displacements are
 * kept. */
static void rebuild(struct neighbours *nb)
{
    const struct chunk_range mine = neighbours_static_range(nb);
    struct rows *const b = nb->rows;

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        if (!nb->stale) save_history(nb, s);
        rows_store(b, nb->ps, own->begin, own->end);
    }
    neighbours_barrier(nb);
    if (mine.first == 0) find_order(nb);
    neighbours_barrier(nb);
    permute_by_all(nb);
    neighbours_barrier(nb);
    if (mine.first == 0) follow_order(nb);
    neighbours_barrier(nb);
    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        rows_load(b, nb->ps, own->begin, own->end);
        if (nb->prescribed != NULL)
            prescribed_particles_set_mass(nb->prescribed, b, nb->ps, own->begin,
                                          own->end, 1);
    }
    fast_clumps_write(nb);
    for (int s = mine.first; s < mine.last; s++)
        rows_record_positions(b, nb->chunks[s].begin, nb->chunks[s].end,
                              nb->ahead);
    neighbours_barrier(nb);
    for (int s = mine.first; s < mine.last; s++) {
        grid_find(nb->grid, &nb->chunks[s], b, nb->skin + nb->range);
        if (nb->surfaces != NULL)
            surfaces_find(nb->surfaces, s, &nb->chunks[s], b, nb->skin);
    }
    neighbours_barrier(nb);
    if (mine.first == 0) nb->stale = 0;
}

/* The contacts of this thread's chunks; after a rebuild they get the histories
 * that all chunks had before it. */
static void choose_contacts(struct neighbours *nb, int rebuilt, double least)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        chunk_choose_contacts(&nb->chunks[s], nb->rows);
        if (nb->surfaces != NULL)
            surfaces_choose_contacts(nb->surfaces, s, nb->rows, 2.0 * least);
    }
    if (!rebuilt) return;
    neighbours_barrier(nb);
    for (int s = mine.first; s < mine.last; s++) {
        for (int q = 0; q < nb->chunks[s].n_history; q++)
            restore_history(nb, &nb->chunks[s], q);
        nb->chunks[s].n_history = 0;
    }
}

/* Lost particles are looked for before a list is made, which one that leaves
 * demands, and at the end of a run; and those that have passed a surface with
 * each choice. */
double neighbours_refresh(struct neighbours *nb, double least, double time)
{
    const double of_surfaces = fmin(least, 0.125 * nb->skin);
    double margin = HUGE_VAL;

    set_margins(nb, least, time);
    const int narrow = list_is_narrow(nb, of_surfaces);
    if (narrow || nb->surfaces != NULL) {
        neighbours_check_lost(nb);
        neighbours_barrier(nb);
        if (is_any_lost(nb)) return -1.0;
    }
    if (narrow) {
        rebuild(nb);
        set_margins(nb, least, time);
    }
    choose_contacts(nb, narrow, of_surfaces);
    neighbours_barrier(nb);
    for (int s = 0; s < nb->n_chunks; s++)
        margin = fmin(margin, nb->chunks[s].margins.least);
    return margin < 0.0 ? -1.0 : 2.0 * margin;
}

/* Two spheres may cross between two steps (dem.h), of which the lists do
 * not know. */
static int is_fast(const struct neighbours *nb, int i, double dt)
{
    const double *const v = nb->rows->motion[i].v;

    return 4.0 * vector_dot(v, v) * dt * dt > nb->smallest * nb->smallest;
}

static int crossings_cross(const struct rows *b, int i, int j, double dt)
{
    const struct row_place *const p = &b->place[i], *const q = &b->place[j];

    return crossing(&b->box, p->x, q->x, b->motion[i].v, b->motion[j].v, dt,
                    p->R + q->R);
}

struct dem_crossing neighbours_crossing(const struct neighbours *nb, double dt)
{
    const struct rows *const b = nb->rows;

    for (int i = 0; i < b->n; i++)
        for (int j = 0; j < b->n && is_fast(nb, i, dt); j++)
            if (j != i && crossings_cross(b, i, j, dt))
                return (struct dem_crossing){1, {b->id[i], b->id[j]}};
    return (struct dem_crossing){0};
}
