/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/dem.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "particles/neighbours.h"

/* The contacts are chosen for about so many steps ahead, and with a margin of
 * at least d / MARGIN_PARTS: the optimum is flat. */
static const double steps_ahead = 12.0;
enum { SKIN_PARTS = 6, MARGIN_PARTS = 600 };

struct dem {
    struct dem_options options;
    struct contact_constants constants;
    contact_sweep *sweep;
    struct neighbours *neighbours;
    double least_margin; /* [m] */
    long done;           /* [-] steps of the run at hand */
    double overlap;      /* [-] largest of the last run */
};

static double mean_diameter(const struct particles *ps)
{
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->d[i];
    return ps->n > 0 ? sum / ps->n : 0.0;
}

static double skin_of(const struct dem_options *o, const struct particles *ps)
{
    return o->skin > 0.0 ? o->skin : mean_diameter(ps) / SKIN_PARTS;
}

static int options_wrong(const struct dem_options *o,
                         const struct particles *ps)
{
    const double skin = skin_of(o, ps);
    double widest = 0.0;

    for (int i = 0; i < ps->n; i++)
        widest = fmax(widest, ps->d[i]);
    for (int k = 0; k < 3; k++)
        if (o->periodic[k] && o->hi[k] - o->lo[k] < 2.0 * (widest + skin)) {
            fprintf(stderr,
                    "winnow: the box is %g m long in the periodic direction "
                    "%c; particles of %g m with a skin of %g m need %g m\n",
                    o->hi[k] - o->lo[k], 'x' + k, widest, skin,
                    2.0 * (widest + skin));
            return 1;
        }
    return 0;
}

struct dem *dem_create(struct particles *ps, const struct dem_options *o)
{
    const int any = o->periodic[0] || o->periodic[1] || o->periodic[2];
    const struct domain box = bodies_domain(o->lo, o->hi, o->periodic);

    if (options_wrong(o, ps)) return NULL;
    struct dem *const dem = alloc_zeroed(1, sizeof *dem);
    dem->options = *o;
    dem->constants = o->law->constants(&o->material);
    dem->sweep = any ? o->law->sweep_periodic : o->law->sweep;
    dem->neighbours = neighbours_create(ps, &box);
    return dem;
}

void dem_free(struct dem *dem)
{
    if (dem == NULL) return;
    neighbours_free(dem->neighbours);
    free(dem);
}

void dem_changed(struct dem *dem)
{
    dem->neighbours->stale = 1;
}

struct dem_spring *dem_springs(struct dem *dem, int *n)
{
    const int *const id = dem->neighbours->ps->id;
    const struct kept *const kept = neighbours_keep(dem->neighbours, n);
    struct dem_spring *const list = alloc_zeroed((size_t)*n, sizeof *list);

    for (int q = 0; q < *n; q++) {
        list[q].id = id[kept[q].owner];
        list[q].other =
            kept[q].partner < 0 ? kept[q].partner : id[kept[q].partner];
        for (int k = 0; k < 3; k++)
            list[q].xi[k] = kept[q].spring[k];
    }
    return list;
}

/* Where each id is now. */
static int *places(const struct particles *ps)
{
    int highest = -1;

    for (int i = 0; i < ps->n; i++)
        highest = ps->id[i] > highest ? ps->id[i] : highest;
    int *const place = alloc_ints(highest + 1);
    for (int i = 0; i < ps->n; i++)
        place[ps->id[i]] = i;
    return place;
}

void dem_recall(struct dem *dem, const struct dem_spring *list, int n)
{
    int *const place = places(dem->neighbours->ps);
    struct kept *const kept = neighbours_recall(dem->neighbours, n);

    for (int q = 0; q < n; q++) {
        kept[q].owner = place[list[q].id];
        kept[q].partner =
            list[q].other < 0 ? list[q].other : place[list[q].other];
        for (int k = 0; k < 3; k++)
            kept[q].spring[k] = list[q].xi[k];
    }
    free(place);
}

void dem_change_material(struct dem *dem, const struct material *m)
{
    dem->options.material = *m;
    dem->constants = dem->options.law->constants(m);
}

/* The functions down to move() are called by every thread of the team. */

/* From the time of the loads on; dt = 0 makes loads only. */
struct stride {
    double dt;          /* [s] springs */
    double kick, drift; /* [s] velocities, places */
};

static void advance(const struct dem *dem, struct strip *own, int begin,
                    int end, const struct stride *by)
{
    bodies_advance(dem->neighbours->bodies, begin, end,
                   own->load + (begin - own->begin), by->kick, by->drift,
                   own->so_far);
}

/* Of the first particles of strip s, how many bear loads from strips that this
 * thread has not done before it. A strip lays loads on later ones; in a
 * periodic direction the first come after the last, in a lone strip, too. */
static int reached(const struct neighbours *nb, int s)
{
    const int *const around = nb->bodies->box.periodic;
    const int n = nb->bodies->n, first = neighbours_share(nb).first;
    int most = 0;

    if (nb->count == 1 && (around[0] || around[1] || around[2])) return n;
    for (int t = 0; t < nb->count; t++) {
        const int done = first <= t && t <= s;
        const int m =
            done ? 0 : strip_reached(&nb->strips[s], &nb->strips[t], n);
        most = m > most ? m : most;
    }
    return most;
}

/* The loads of the contacts that end with this block. */
static void load_block(const struct dem *dem, struct strip *own, int k,
                       double dt)
{
    const struct bodies *const b = dem->neighbours->bodies;
    const struct contact_constants *const law = &dem->constants;
    const struct block begin = {own->begin, 0, own->contacts.n_pairs, 0};
    const struct block *const to = &own->blocks[k];
    const struct block *const from = k > 0 ? to - 1 : &begin;

    memset(own->load + from->reach, 0,
           (size_t)(to->reach - from->reach) * sizeof *own->load);
    dem->sweep(own, b, law, dt, from->pairs, to->pairs);
    dem->sweep(own, b, law, dt, from->walls, to->walls);
}

/* Loads, then motion, block by block; those on which other threads may still
 * lay loads, or whose places these still need, move when all are done. */
static void step_strip(const struct dem *dem, int s, const struct stride *by,
                       int waiting)
{
    const struct neighbours *const nb = dem->neighbours;
    struct strip *const own = &nb->strips[s];
    const int late = own->begin + reached(nb, s);

    for (int k = 0, begin = own->begin; k < own->n_blocks; k++) {
        const int end = own->blocks[k].end;
        if (!waiting) load_block(dem, own, k, by->dt);
        if ((begin < late) == waiting) {
            strip_fold(nb->strips, nb->count, s, nb->bodies->n, begin, end);
            advance(dem, own, begin, end, by);
        }
        begin = end;
    }
}

/* What it found is shown to all when all are done with what was found before.
 */
static void show_fastest(struct strip *own)
{
    memcpy(own->fastest, own->so_far, sizeof own->fastest);
    memset(own->so_far, 0, sizeof own->so_far);
}

static void step(const struct dem *dem, const struct stride *by)
{
    const struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++)
        step_strip(dem, s, by, 0);
    neighbours_meet(nb);
    for (int s = mine.first; s < mine.last; s++) {
        step_strip(dem, s, by, 1);
        show_fastest(&nb->strips[s]);
    }
}

/* Lists and loads for particles that were changed from outside; no time
 * passes. */
static int start(struct dem *dem, double *margin)
{
    *margin = neighbours_refresh(dem->neighbours, dem->least_margin);
    if (*margin < 0.0) return 1;
    step(dem, &(struct stride){0.0, 0.0, 0.0});
    return 0;
}

/* From the loads that there are. */
static void begin(const struct dem *dem)
{
    const struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);
    const double dt = dem->options.step;
    const struct stride half = {0.0, 0.5 * dt, dt};

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        advance(dem, own, own->begin, own->end, &half);
        show_fastest(own);
    }
}

static void finish(struct dem *dem)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    neighbours_look(nb);
    for (int s = mine.first; s < mine.last; s++)
        strip_measure(&nb->strips[s], nb->bodies);
}

/* The first drift follows half a kick, each later one a whole kick, and the
 * last half kick brings the velocities to the time of the places. Each thread
 * counts for itself what all of them see: margin, spent. */
static void move(struct dem *dem, int steps)
{
    struct neighbours *const nb = dem->neighbours;
    const double dt = dem->options.step;
    const struct stride whole = {dt, dt, dt}, to_the_end = {dt, 0.5 * dt, 0.0};
    double margin = nb->margin, spent = nb->spent;
    int k = 0;

    if (nb->stale && start(dem, &margin) != 0) return;
    if (steps > 0) begin(dem);
    for (; k < steps; k++) {
        const int last = k + 1 == steps;
        neighbours_meet(nb);
        const double closer = 2.0 * neighbours_speed(nb) * dt; /* [LS 5.16] */
        spent += closer;
        if (spent > margin) {
            margin = neighbours_refresh(
                nb, fmax(dem->least_margin, steps_ahead * closer));
            spent = 0.0;
        }
        if (margin < 0.0) break;
        step(dem, last ? &to_the_end : &whole);
    }
    finish(dem);
    neighbours_meet(nb);
    if (omp_get_thread_num() == 0) {
        nb->margin = margin;
        nb->spent = spent;
        dem->done = k;
    }
}

static void report_lost(const struct neighbours *nb, struct dem_report *r)
{
    r->lost_id = -1;
    for (int s = 0; s < nb->count; s++) {
        const struct bodies_survey *const found = &nb->strips[s].survey;
        if (found->lost > 0 && r->lost == 0) {
            r->lost_id = nb->ps->id[found->first];
            for (int k = 0; k < 3; k++)
                r->lost_at[k] = nb->bodies->place[found->first][k];
        }
        r->lost += found->lost;
    }
}

static void report(struct dem *dem, long rebuilds, struct dem_report *r)
{
    const struct neighbours *const nb = dem->neighbours;

    *r = (struct dem_report){.steps = dem->done, .rebuilds = rebuilds};
    for (int s = 0; s < nb->count; s++) {
        const struct strip *const own = &nb->strips[s];
        r->contacts += own->measures.contacts;
        r->max_overlap = fmax(r->max_overlap, own->deepest);
        r->max_speed = fmax(r->max_speed, sqrt(own->measures.speed2));
        r->translation += own->measures.translation;
        r->rotation += own->measures.rotation;
    }
    report_lost(nb, r);
    /* who is lost was too deep in something before this run saw it */
    const double now = r->max_overlap;
    if (r->lost > 0) r->max_overlap = fmax(now, dem->overlap);
    dem->overlap = now;
}

static int team_size(const struct neighbours *nb)
{
    const int most = omp_get_max_threads();
    return most < nb->count ? most : nb->count;
}

int dem_run(struct dem *dem, int steps, struct dem_report *r)
{
    struct neighbours *const nb = dem->neighbours;
    const long before = nb->rebuilds;

    if (nb->stale) {
        nb->skin = skin_of(&dem->options, nb->ps);
        dem->least_margin = mean_diameter(nb->ps) / MARGIN_PARTS;
    }
    neighbours_open(nb);
#pragma omp parallel num_threads(team_size(nb))
    move(dem, steps);
    neighbours_close(nb);
    report(dem, nb->rebuilds - before, r);
    return r->lost > 0;
}
