/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/dem.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "particles/energy.h"
#include "particles/neighbours.h"
#include "particles/response.h"

/* The contacts are chosen for about so many steps ahead, and with a margin of
 * at least d / MARGIN_PARTS: the optimum is flat. */
static const double steps_ahead = 12.0;
enum { SKIN_PARTS = 6, MARGIN_PARTS = 600 };

struct dem {
    struct dem_options options;
    struct contact_constants *constants; /* of each pair of materials */
    contact_sweep *sweep;
    struct neighbours *neighbours;
    double least_margin;   /* [m] */
    long done;             /* [-] steps of the run at hand */
    double overlap;        /* [-] largest of the last run */
    struct energy *energy; /* NULL: no budget is kept */
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

/* What the loop over the contacts must know of (contact.h). */
static int loop_of(const struct dem_options *o)
{
    const int periodic = o->periodic[0] || o->periodic[1] || o->periodic[2];
    const int rolls = materials_roll(&o->material, o->materials);
    const int many = materials_count(o->materials) > 1 || rolls;

    return periodic * CONTACT_PERIODIC + many * CONTACT_MANY +
           rolls * CONTACT_ROLLING;
}

struct dem *dem_create(struct particles *ps, const struct dem_options *o)
{
    const int loop = loop_of(o), n = materials_count(o->materials);
    const struct domain box = bodies_domain(o->lo, o->hi, o->periodic);

    if (options_wrong(o, ps)) return NULL;
    struct dem *const dem = alloc_zeroed(1, sizeof *dem);
    dem->options = *o;
    dem->constants = alloc_zeroed((size_t)(n * n), sizeof *dem->constants);
    materials_table(o->law, &o->material, o->materials, dem->constants);
    dem->sweep = o->law->sweep[loop];
    dem->neighbours = neighbours_create(ps, &box);
    dem->neighbours->bodies->step = o->step;
    dem->neighbours->bodies->n_materials = n;
    if (o->materials != NULL)
        dem->neighbours->bodies->wall_material = o->materials->wall;
    if (loop & CONTACT_ROLLING) neighbours_keep_rolling(dem->neighbours);
    return dem;
}

void dem_free(struct dem *dem)
{
    if (dem == NULL) return;
    neighbours_free(dem->neighbours);
    free(dem->constants);
    free(dem->energy);
    free(dem);
}

void dem_keep_energy(struct dem *dem)
{
    const int loop = loop_of(&dem->options) | CONTACT_MANY | CONTACT_BUDGET;

    dem->sweep = dem->options.law->sweep[loop];
    if (dem->energy == NULL) dem->energy = alloc_zeroed(1, sizeof *dem->energy);
    dem->neighbours->stale = 1; /* what the contacts store is to be seen */
}

const struct energy *dem_energy(const struct dem *dem)
{
    return dem->energy;
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
        for (int k = 0; k < 3; k++) {
            list[q].xi[k] = kept[q].spring[k];
            list[q].roll[k] = kept[q].roll[k];
        }
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
        for (int k = 0; k < 3; k++) {
            kept[q].spring[k] = list[q].xi[k];
            kept[q].roll[k] = list[q].roll[k];
        }
    }
    free(place);
}

void dem_change_material(struct dem *dem, const struct material *m)
{
    dem->options.material = *m;
    materials_table(dem->options.law, m, dem->options.materials,
                    dem->constants);
}

/* The functions down to move() are called by every thread of the team. */

static void advance(const struct dem *dem, double kick, double drift)
{
    const struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        if (nb->bodies->response == NULL)
            bodies_advance(nb->bodies, own->begin, own->end, own->load, kick,
                           drift, own->fastest);
        else
            response_advance(nb->bodies, own->begin, own->end, own->load, kick,
                             drift, own->fastest);
        if (dem->energy != NULL) strip_work(own, nb->bodies, drift);
    }
}

static void forces(const struct dem *dem, double dt)
{
    const struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++)
        dem->sweep(&nb->strips[s], nb->bodies, dem->constants, dt);
    neighbours_meet(nb);
    for (int s = mine.first; s < mine.last; s++)
        strip_fold(nb->strips, nb->count, s, nb->bodies->n);
}

/* Lists and forces for particles that were changed from outside; no time
 * passes. */
static int start(struct dem *dem, double *margin)
{
    *margin = neighbours_refresh(dem->neighbours, dem->least_margin);
    if (*margin < 0.0) return 1;
    forces(dem, 0.0);
    return 0;
}

static void measure(struct dem *dem)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++)
        strip_measure(&nb->strips[s], nb->bodies);
}

/* The energy of now, and what has come since the last run. */
static void open_budget(struct dem *dem)
{
    struct energy *const e = dem->energy;

    measure(dem);
    neighbours_meet(dem->neighbours);
    if (omp_get_thread_num() == 0) {
        const struct energy before = *e;
        *e = energy_collect(dem->neighbours, dem->options.law->stored);
        e->brought = before.brought;
        e->brought += energy_residual(e) - energy_residual(&before);
    }
    neighbours_meet(dem->neighbours);
}

/* The first drift follows half a kick, each later one a whole kick, and the
 * last half kick brings the velocities to the time of the places. Each thread
 * counts for itself what all of them see: margin, spent. */
static void move(struct dem *dem, int steps)
{
    struct neighbours *const nb = dem->neighbours;
    const double dt = dem->options.step;
    double margin = nb->margin, spent = nb->spent;
    int k = 0;

    if (nb->stale && start(dem, &margin) != 0) return;
    if (dem->energy != NULL) open_budget(dem);
    if (steps > 0) advance(dem, 0.5 * dt, dt);
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
        forces(dem, dt);
        advance(dem, last ? 0.5 * dt : dt, last ? 0.0 : dt);
    }
    neighbours_look(nb);
    measure(dem);
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

static void close_budget(struct dem *dem)
{
    const double brought = dem->energy->brought;

    *dem->energy = energy_collect(dem->neighbours, dem->options.law->stored);
    dem->energy->brought = brought;
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
    if (dem->energy != NULL) close_budget(dem);
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
