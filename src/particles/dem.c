/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/dem_inside.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"

/* The contacts are chosen with a margin of at least d / MARGIN_PARTS: the
 * optimum is flat. */
enum { SKIN_PARTS = 6, MARGIN_PARTS = 600 };

static double mean_diameter(const struct particles *ps)
{
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->d[i];
    return ps->n > 0 ? sum / ps->n : 0.0;
}

static double skin_of(const struct dem_options *o, const struct particles *ps)
{
    if (o->link_cells) return mean_diameter(ps) / MARGIN_PARTS;
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
    dem->expected = dem->most = HUGE_VAL;
    if (o->integrator == NULL) dem->options.integrator = &integrators[0];
    if (dem->options.integrator->predicts)
        dem->start = integrators_start_create(ps->capacity);
    dem->constants = alloc_zeroed((size_t)(n * n), sizeof *dem->constants);
    materials_table(o->law, &o->material, o->materials, dem->constants);
    dem->sweep = o->law->sweep[loop];
    dem->neighbours = neighbours_create(ps, &box);
    dem->neighbours->bodies->step = o->step;
    if (o->n_surfaces > 0)
        dem->neighbours->surfaces = surfaces_create(
            o->surfaces, o->n_surfaces, &dem->neighbours->bodies->box,
            dem->neighbours->count);
    if (o->n_driven > 0)
        dem->neighbours->drive = driven_create(o->driven, o->n_driven);
    dem->neighbours->fresh = o->link_cells;
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
    free(dem->energy);
    integrators_start_free(dem->start);
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

void dem_change_material(struct dem *dem, const struct material *m)
{
    dem->options.material = *m;
    materials_table(dem->options.law, m, dem->options.materials,
                    dem->constants);
}

void dem_limit_overlap(struct dem *dem, double expected, double most)
{
    dem->expected = expected;
    dem->most = most;
    neighbours_watch(dem->neighbours, expected);
}

struct dem_overlap dem_deepest(const struct dem *dem)
{
    const struct neighbours *const nb = dem->neighbours;
    struct dem_overlap deep = {0.0, -1, -1, {0.0}, dem->expected, dem->most};

    for (int s = 0; s < nb->count; s++) {
        const struct strip_deep *const own = &nb->strips[s].deep;
        if (own->id < 0 || own->overlap <= deep.depth) continue;
        deep.depth = own->overlap;
        deep.id = own->id;
        deep.other = own->other;
        for (int k = 0; k < 3; k++)
            deep.at[k] = bodies_inside(&nb->bodies->box, k, own->at[k]);
    }
    return deep;
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
    if (nb->surfaces != NULL) {
        r->contacts += surfaces_contacts(nb->surfaces);
        r->max_overlap = fmax(r->max_overlap, surfaces_deepest(nb->surfaces));
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
    dem_move(dem, steps);
    report(dem, nb->rebuilds - before, r);
    return r->lost > 0 || r->max_overlap > dem->most;
}
