/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/fast.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "dem/fast/sweep.h"
#include "dem/particles_setup.h"

/* The skin is d / SKIN_PARTS, and down to d / THINNEST_SKIN in a periodic box
 * that has no room for that. The optima are flat. */
enum { SKIN_PARTS = 3, THINNEST_SKIN = 6 };

static double skin_of(const struct dem_options *o, double mean)
{
    double skin = mean / SKIN_PARTS;

    for (int k = 0; k < 3; k++) {
        const double room = 0.5 * (o->hi[k] - o->lo[k]) - mean - dem_range(o);
        if (o->periodic[k]) skin = fmin(skin, fmax(room, mean / THINNEST_SKIN));
    }
    return o->skin > 0.0 ? o->skin : skin;
}

/* The stages of the contact loop that a case needs (sweep.h). */
static int loop_of(const struct dem_options *o, int budget)
{
    const int periodic = o->periodic[0] || o->periodic[1] || o->periodic[2];
    const int rolls = materials_have_rolling(&o->material, o->materials);
    const int many = materials_count(o->materials) > 1 || rolls || budget;

    return periodic * SWEEP_PERIODIC + many * SWEEP_MULTI_MATERIAL +
           rolls * SWEEP_ROLLING + budget * SWEEP_BUDGET;
}

static struct neighbours *create_neighbours(const struct dem *dem)
{
    const struct dem_options *const o = &dem->options;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    struct neighbours *const nb = neighbours_create(dem->ps, &box);

    nb->rows->law = o->law;
    nb->rows->step = o->step;
    nb->rows->sweep_options = loop_of(o, 0);
    nb->rows->n_materials = materials_count(o->materials);
    if (o->materials != NULL) nb->rows->wall_material = o->materials->wall;
    nb->range = dem_range(o);
    if (o->n_surfaces > 0)
        nb->surfaces = surfaces_create(o->surfaces, o->n_surfaces,
                                       &nb->rows->box, nb->n_chunks);
    if (o->n_prescribed > 0) {
        nb->prescribed =
            prescribed_particles_create(o->prescribed, o->n_prescribed);
        nb->rows->own_inverse_mass = owner_doubles(nb->rows, dem->ps->capacity);
    }
    return nb;
}

static void add_heun(struct fast *fast, int capacity)
{
    struct heun *const h = &fast->heun;
    const size_t n = (size_t)capacity;

    h->place = owner_zeroed(fast, n, sizeof *h->place);
    h->motion = owner_zeroed(fast, n, sizeof *h->motion);
    h->load = owner_zeroed(fast, n, sizeof *h->load);
}

static int fast_create(struct dem *dem)
{
    const struct dem_options *const o = &dem->options;

    for (int s = 0; s < o->n_surfaces; s++)
        if (surface_wrong(&o->surfaces[s])) return 1;
    struct fast *const fast = dem->state = owner_create(sizeof *fast);
    if (o->integrator->predicts) add_heun(fast, dem->ps->capacity);
    fast->neighbours = create_neighbours(dem);
    if (o->integrator->adapts)
        fast->adaptive = (struct adaptive){
            .next = o->shortest_step,
            .changed = owner_doubles(fast, fast->neighbours->n_chunks),
            .closes = owner_doubles(fast, fast->neighbours->n_chunks)};
    if (fast->neighbours->rows->sweep_options & SWEEP_ROLLING)
        neighbours_add_rolling(fast->neighbours);
    return 0;
}

static void fast_release(struct dem *dem)
{
    struct fast *const fast = fast_of(dem);

    if (fast == NULL) return;
    neighbours_free(fast->neighbours);
    owner_free(fast);
}

/* Allocates what a budget of energy needs, once. */
static void fast_add_budget(struct fast *fast, int capacity)
{
    struct neighbours *const nb = fast->neighbours;
    const size_t n = (size_t)capacity;

    if (nb->rows->before != NULL) return;
    nb->rows->before = owner_zeroed(nb->rows, n, sizeof *nb->rows->before);
    for (int s = 0; s < nb->n_chunks; s++)
        nb->chunks[s].has_budget = 1;
    if (fast->heun.load != NULL)
        fast->heun.part = owner_zeroed(fast, n, sizeof *fast->heun.part);
}

static void fast_changed(struct dem *dem)
{
    struct fast *const fast = fast_of(dem);

    if (dem->energy != NULL) fast_add_budget(fast, dem->ps->capacity);
    fast->neighbours->rows->sweep_options =
        loop_of(&dem->options, dem->energy != NULL);
    fast->neighbours->stale = 1;
}

static void fast_limit_overlap(struct dem *dem)
{
    neighbours_watch(fast_of(dem)->neighbours, dem->deepest.expected);
}

static void find_deepest(struct dem *dem)
{
    const struct neighbours *const nb = fast_of(dem)->neighbours;
    struct dem_overlap *const deep = &dem->deepest;

    for (int s = 0; s < nb->n_chunks; s++) {
        struct dem_overlap own = nb->chunks[s].deep;
        if (own.id < 0) continue;
        for (int k = 0; k < 3; k++)
            own.at[k] = box_domain_inside(&nb->rows->box, k, own.at[k]);
        chunk_record_overlap(deep, own.depth, own.id, own.other, own.at);
    }
}

static void report_lost(const struct neighbours *nb, struct dem_report *r)
{
    r->lost_id = r->lost_through = -1;
    for (int s = 0; s < nb->n_chunks; s++) {
        const struct rows_survey *const found = &nb->chunks[s].survey;
        if (found->lost > 0 && r->lost == 0) {
            r->lost_id = nb->ps->id[found->first_lost];
            r->lost_through = found->lost_through;
            for (int k = 0; k < 3; k++)
                r->lost_at[k] = nb->rows->place[found->first_lost].x[k];
        }
        r->lost += found->lost;
    }
}

static void close_budget(struct dem *dem)
{
    const double added = dem->energy->added;

    *dem->energy = neighbours_energy(fast_of(dem)->neighbours);
    dem->energy->added = added;
}

static void fast_report(struct dem *dem, long rebuilds, struct dem_report *r)
{
    const struct neighbours *const nb = fast_of(dem)->neighbours;

    *r = (struct dem_report){.steps = fast_of(dem)->steps_done,
                             .parts = fast_of(dem)->parts,
                             .rebuilds = rebuilds,
                             .crossing = fast_of(dem)->crossing};
    for (int s = 0; s < nb->n_chunks; s++) {
        const struct chunk *const own = &nb->chunks[s];
        r->contacts += own->measures.contacts;
        r->max_overlap = fmax(r->max_overlap, own->max_overlap);
        r->max_speed = fmax(r->max_speed, sqrt(own->measures.speed2));
        r->translation += own->measures.translation;
        r->rotation += own->measures.rotation;
        if (nb->surfaces == NULL) continue;
        const struct surface_contacts *const c = &nb->surfaces->chunk[s];
        r->contacts += c->touches.n;
        r->max_overlap = fmax(r->max_overlap, c->pairs.max_overlap);
    }
    if (dem->energy != NULL) close_budget(dem);
    report_lost(nb, r);
    find_deepest(dem);
}

static void fast_run(struct dem *dem, int steps, struct dem_report *r)
{
    struct fast *const fast = fast_of(dem);
    struct neighbours *const nb = fast->neighbours;
    const long before = nb->rebuilds;
    const int most = omp_get_max_threads();
    const int team = most < nb->n_chunks ? most : nb->n_chunks;

    if (nb->stale) {
        nb->skin = skin_of(&dem->options, dem_mean_diameter(nb->ps));
        fast->min_margin = dem_mean_diameter(nb->ps) / MARGIN_PARTS;
    }
    if (nb->stale || nb->smallest == 0.0)
        nb->smallest = dem_least_diameter(dem->ps);
    fast->crossing.found = 0;
    neighbours_begin_run(nb, team);
#pragma omp parallel num_threads(team)
    fast_move(dem, steps);
    fast_report(dem, nb->rebuilds - before, r);
}

static const struct key skin_keys[] = {
    {"particles.skin", KEY_REAL, "m", "auto | > 0", "auto",
     "margin of the neighbour list beyond touching; auto: d/3", "LS 5.15", "",
     KEY_AT(particles_setup, skin), .divided = KEY_DIVIDED},
    KEY_END};

const struct dem_method fast_verlet = {
    .name = "verlet",
    .what = "a list of pairs with gaps up to the skin, made anew when "
            "particles have moved by it",
    .equations = "LS 5.15, 5.16",
    .function = "neighbours_refresh",
    .keys = {skin_keys},
    .skin = skin_of,
    .create = fast_create,
    .free = fast_release,
    .run = fast_run,
    .changed = fast_changed,
    .limit_overlap = fast_limit_overlap,
    .visit = fast_state,
    .histories = fast_histories,
    .restore_histories = fast_restore_histories};
