/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/dem.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "particles/stride.h"
#include "particles/surface_springs.h"

/* The contacts are chosen for about so many steps ahead, and with a margin of
 * at least d / MARGIN_PARTS: the optimum is flat. */
static const double steps_ahead = 12.0;
enum { SKIN_PARTS = 6, MARGIN_PARTS = 600 };

struct dem {
    struct dem_options options;
    struct contact_constants *constants; /* of each pair of materials */
    contact_sweep *sweep;
    struct neighbours *neighbours;
    double least_margin; /* [m] */
    long done;           /* [-] steps of the run at hand */
    long tick;           /* [-] steps of the surfaces' clock */
    int ticking;         /* [-] 1: it runs */
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

/* How far anything acts beyond touching. */
static double range_of(const struct dem_options *o)
{
    double range = 0.0;

    for (int k = 0; k < o->n_attractions; k++)
        range = fmax(range, o->attractions[k].range);
    return range;
}

static int options_wrong(const struct dem_options *o,
                         const struct particles *ps)
{
    const double skin = skin_of(o, ps) + range_of(o);
    double widest = 0.0;

    for (int i = 0; i < ps->n; i++)
        widest = fmax(widest, ps->d[i]);
    for (int k = 0; k < 3; k++)
        if (o->periodic[k] && o->hi[k] - o->lo[k] < 2.0 * (widest + skin)) {
            fprintf(stderr,
                    "winnow: the box is %g m long in the periodic direction "
                    "%c; particles of %g m that are listed up to a gap of %g m "
                    "need %g m\n",
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

    for (int s = 0; s < o->n_surfaces; s++)
        if (surface_wrong(&o->surfaces[s])) return NULL;
    if (options_wrong(o, ps)) return NULL;
    struct dem *const dem = alloc_zeroed(1, sizeof *dem);
    dem->options = *o;
    dem->constants = alloc_zeroed((size_t)(n * n), sizeof *dem->constants);
    materials_table(o->law, &o->material, o->materials, dem->constants);
    dem->sweep = o->law->sweep[loop];
    dem->neighbours = neighbours_create(ps, &box);
    dem->neighbours->bodies->step = o->step;
    if (o->n_surfaces > 0)
        dem->neighbours->surfaces = surfaces_create(
            o->surfaces, o->n_surfaces, &dem->neighbours->bodies->box,
            dem->neighbours->count);
    dem->neighbours->bodies->n_materials = n;
    dem->neighbours->range = range_of(o);
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
    free(dem);
}

void dem_changed(struct dem *dem)
{
    dem->neighbours->stale = 1;
}

void dem_clock(struct dem *dem, long steps)
{
    dem->tick = steps;
    dem->ticking = 1;
}

struct dem_surface dem_surface(const struct dem *dem, int k)
{
    const struct surface_account a =
        surfaces_account(dem->neighbours->surfaces, k);
    struct dem_surface r = {.work = a.work};

    r.pose = motion_pose(&dem->options.surfaces[k].motion,
                         (double)dem->tick * dem->options.step);
    memcpy(r.impulse, a.impulse, sizeof r.impulse);
    memcpy(r.angular, a.angular, sizeof r.angular);
    return r;
}

struct dem_spring *dem_springs(struct dem *dem, int *n)
{
    struct neighbours *const nb = dem->neighbours;
    const struct particles *const ps = nb->recalled ? NULL : nb->ps;
    const int *const id = nb->ps->id;
    const struct kept *const kept = neighbours_keep(nb, n);
    const int more = surface_springs(nb->surfaces, ps, NULL);
    struct dem_spring *const list =
        alloc_zeroed((size_t)(*n + more), sizeof *list);

    for (int q = 0; q < *n; q++) {
        list[q].id = id[kept[q].owner];
        list[q].other =
            kept[q].partner < 0 ? kept[q].partner : id[kept[q].partner];
        for (int k = 0; k < 3; k++) {
            list[q].xi[k] = kept[q].spring[k];
            list[q].roll[k] = kept[q].roll[k];
        }
    }
    surface_springs(nb->surfaces, ps, list + *n);
    *n += more;
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
    struct neighbours *const nb = dem->neighbours;
    int *const place = places(nb->ps);
    const int own = n - surface_springs_recall(nb->surfaces, list, n);
    struct kept *const kept = neighbours_recall(nb, own);

    for (int q = 0; q < own; q++) {
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

/* The surfaces where they are after k steps of this run. */
static void move_surfaces(const struct dem *dem, int k)
{
    const struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);
    const double t = (double)(dem->tick + (dem->ticking ? k : 0));

    for (int s = mine.first; s < mine.last; s++)
        surfaces_move(nb->surfaces, s, t * dem->options.step);
}

static struct stride stride(const struct dem *dem, double dt, double kick,
                            double drift)
{
    return (struct stride){.sweep = dem->sweep,
                           .constants = dem->constants,
                           .attractions = dem->options.attractions,
                           .n_attractions = dem->options.n_attractions,
                           .dt = dt,
                           .kick = kick,
                           .drift = drift};
}

/* Lists and loads for particles that were changed from outside; no time
 * passes. */
static int start(struct dem *dem, double *margin)
{
    const struct stride still = stride(dem, 0.0, 0.0, 0.0);

    *margin = neighbours_refresh(dem->neighbours, dem->least_margin);
    if (*margin < 0.0) return 1;
    stride_take(dem->neighbours, &still);
    return 0;
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
    const struct stride first = stride(dem, 0.0, 0.5 * dt, dt);
    const struct stride whole = stride(dem, dt, dt, dt);
    const struct stride last = stride(dem, dt, 0.5 * dt, 0.0);
    double margin = nb->margin, spent = nb->spent;
    int k = 0;

    if (nb->surfaces != NULL) move_surfaces(dem, 0);
    if (nb->stale && start(dem, &margin) != 0) return;
    if (steps > 0) stride_move(nb, &first);
    for (; k < steps; k++) {
        neighbours_meet(nb);
        if (nb->surfaces != NULL) move_surfaces(dem, k + 1);
        const double closer = 2.0 * neighbours_speed(nb) * dt; /* [LS 5.16] */
        spent += closer;
        if (spent > margin) {
            margin = neighbours_refresh(
                nb, fmax(dem->least_margin, steps_ahead * closer));
            spent = 0.0;
        }
        if (margin < 0.0) break;
        stride_take(nb, k + 1 < steps ? &whole : &last);
    }
    finish(dem);
    neighbours_meet(nb);
    if (omp_get_thread_num() == 0) {
        nb->margin = margin;
        nb->spent = spent;
        dem->done = k;
        dem->tick += dem->ticking ? k : 0;
    }
}

static void report_lost(const struct neighbours *nb, struct dem_report *r)
{
    r->lost_id = r->lost_through = -1;
    for (int s = 0; s < nb->count; s++) {
        const struct bodies_survey *const found = &nb->strips[s].survey;
        if (found->lost > 0 && r->lost == 0) {
            r->lost_id = nb->ps->id[found->first];
            r->lost_through = found->through;
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
    if (nb->surfaces != NULL) {
        r->contacts += surfaces_contacts(nb->surfaces);
        r->max_overlap = fmax(r->max_overlap, surfaces_deepest(nb->surfaces));
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
