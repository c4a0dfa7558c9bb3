/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/dem_method.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/model.h"
#include "dem/particles_setup.h"
#include "dem/energy.h"
#include "dem/integrator.h"

double dem_mean_diameter(const struct particles *ps)
{
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->d[i];
    return ps->n > 0 ? sum / ps->n : 0.0;
}

double dem_least_diameter(const struct particles *ps)
{
    double least = HUGE_VAL;

    for (int i = 0; i < ps->n; i++)
        least = fmin(least, ps->d[i]);
    return least;
}

double dem_range(const struct dem_options *o)
{
    double range = 0.0;

    for (int k = 0; k < o->n_attractions; k++)
        range = fmax(range, o->attractions[k].range);
    return range;
}

static const struct dem_method *method_of(const struct dem_options *o)
{
    return o->method != NULL ? o->method : dem_methods[0];
}

int dem_period_wrong(const struct dem_options *o, double widest, double mean)
{
    const struct dem_method *const method = method_of(o);
    const double gap = method->skin != NULL ? method->skin(o, mean) : 0.0;
    const double skin = gap + dem_range(o);

    for (int k = 0; k < 3; k++)
        if (o->periodic[k] && o->hi[k] - o->lo[k] < 2.0 * (widest + skin)) {
            fprintf(stderr,
                    "winnow: %sthe box is %g m long in the periodic direction "
                    "%c; particles of %g m that are listed up to a gap of %g m "
                    "need %g m\n",
                    o->where, o->hi[k] - o->lo[k], 'x' + k, widest, skin,
                    2.0 * (widest + skin));
            return 1;
        }
    return 0;
}

const char *dem_unsupported(const struct dem_options *o)
{
    const struct dem_method *const by = method_of(o);

    return by->unsupported != NULL ? by->unsupported(o) : NULL;
}

static int options_wrong(const struct dem_options *o,
                         const struct particles *ps)
{
    const char *const unsupported = dem_unsupported(o);

    if (unsupported != NULL) {
        fprintf(stderr, "winnow: particles.list = \"%s\" does not support %s\n",
                method_of(o)->name, unsupported);
        return 1;
    }
    return dem_period_wrong(o, particles_widest(ps), dem_mean_diameter(ps));
}

struct dem *dem_create(struct particles *ps, const struct dem_options *o)
{
    const int n = materials_count(o->materials);

    if (options_wrong(o, ps)) return NULL;
    struct dem *const dem = owner_create(sizeof *dem);
    dem->options = *o;
    dem->ps = ps;
    dem->method = method_of(o);
    dem->deepest = (struct dem_overlap){
        .id = -1, .other = -1, .expected = HUGE_VAL, .most = HUGE_VAL};
    if (o->integrator == NULL) dem->options.integrator = integrators[0];
    dem->constants =
        owner_zeroed(dem, (size_t)n * (size_t)n, sizeof *dem->constants);
    materials_table(o->law, &o->material, o->materials, dem->constants);
    if (dem->method->create == NULL || dem->method->create(dem) == 0)
        return dem;
    dem_free(dem);
    return NULL;
}

void dem_free(struct dem *dem)
{
    if (dem == NULL) return;
    dem->method->free(dem);
    owner_free(dem);
}

const struct dem_options *dem_created_with(const struct dem *dem)
{
    return &dem->options;
}

int dem_run(struct dem *dem, int steps, struct dem_report *r)
{
    dem->method->run(dem, steps, r);
    /* a lost particle had too deep an overlap before this run */
    const double now = r->max_overlap;
    if (r->lost > 0) r->max_overlap = fmax(now, dem->max_overlap);
    dem->max_overlap = now;
    return r->lost > 0 || r->steps < steps ||
           r->max_overlap > dem->deepest.most;
}

void dem_start_energy_budget(struct dem *dem)
{
    if (dem->energy == NULL)
        dem->energy = owner_zeroed(dem, 1, sizeof *dem->energy);
    dem_changed(dem); /* what the contacts store is summed anew */
}

const struct energy *dem_energy(const struct dem *dem)
{
    return dem->energy;
}

void dem_changed(struct dem *dem)
{
    if (dem->method->changed != NULL) dem->method->changed(dem);
}

void dem_change_material(struct dem *dem, const struct material *m)
{
    dem->options.material = *m;
    materials_table(dem->options.law, m, dem->options.materials,
                    dem->constants);
}

void dem_limit_overlap(struct dem *dem, double expected, double most)
{
    dem->deepest = (struct dem_overlap){
        .id = -1, .other = -1, .expected = expected, .most = most};
    if (dem->method->limit_overlap != NULL) dem->method->limit_overlap(dem);
}

struct dem_overlap dem_deepest(const struct dem *dem)
{
    return dem->deepest;
}

void dem_clock(struct dem *dem, long steps)
{
    dem->motion_steps = steps;
    dem->motion_on = 1;
}

/* Each is one of the case; they are loaded before. */
static int dem_materials_exist(const struct dem *dem)
{
    const int *const material = dem->ps->material;
    const int n = materials_count(dem->options.materials);

    for (int i = 0; material != NULL && i < dem->ps->n; i++)
        if (material[i] < 0 || material[i] >= n) return 0;
    return 1;
}

void dem_state(struct dem *dem, struct state *s)
{
    struct dem_overlap *const deep = &dem->deepest;

    state_begin(s, "dem");
    state_demand(s, dem_materials_exist(dem),
                 "a particle of a material that the case does not have");
    state_long(s, "motion_steps", "-", &dem->motion_steps);
    state_whole(s, "motion_on", "-", &dem->motion_on);
    state_real(s, "max_overlap", "-", &dem->max_overlap);
    state_begin(s, "deepest_overlap");
    state_real(s, "depth", "-", &deep->depth);
    state_whole(s, "id", "-", &deep->id);
    state_whole(s, "other", "-", &deep->other);
    state_reals(s, "at", "m", deep->at, 3, 1);
    state_end(s);
    if (dem->energy != NULL) energy_state(dem->energy, s);
    dem->method->visit(dem, s);
    state_end(s);
}

struct dem_history *dem_histories(struct dem *dem, int *n)
{
    return dem->method->histories(dem, n);
}

/* The index of each id; -1: there is no such particle. */
static int *indices(const struct particles *ps)
{
    int *const index = alloc_ints(ps->next_id);

    for (int id = 0; id < ps->next_id; id++)
        index[id] = -1;
    for (int i = 0; i < ps->n; i++)
        index[ps->id[i]] = i;
    return index;
}

static int exists(const struct dem_history *h, const int *index)
{
    return index[h->id] >= 0 && (h->other < 0 || index[h->other] >= 0);
}

void dem_restore_histories(struct dem *dem, const struct dem_history *all,
                           int n)
{
    struct dem_history *const list = alloc_zeroed((size_t)n, sizeof *list);
    int *const index = indices(dem->ps);
    int count = 0;

    for (int q = 0; q < n; q++)
        if (exists(&all[q], index)) list[count++] = all[q];
    dem->method->restore_histories(dem, list, count, index);
    free(list);
    free(index);
}

void dem_remove(struct dem *dem, const int *removed)
{
    int n;
    struct dem_history *const histories = dem_histories(dem, &n);

    particles_remove(dem->ps, removed);
    dem_restore_histories(dem, histories, n);
    free(histories);
}

/* --- energy --------------------------------------------------------------- */

double energy_residual(const struct energy *e)
{
    return e->kinetic + e->normal + e->tangential + e->damped_n + e->damped_t +
           e->slid + e->released + e->rolled - e->work - e->attracted -
           e->walls - e->added;
}

void energy_state(struct energy *e, struct state *s)
{
    double *const all[] = {&e->kinetic,   &e->normal,   &e->tangential,
                           &e->damped_n,  &e->damped_t, &e->slid,
                           &e->released,  &e->rolled,   &e->work,
                           &e->attracted, &e->walls,    &e->added};

    state_several(s, "energy", "J", all, sizeof all / sizeof *all);
}

const struct dem_method *const dem_methods[] = {
    &fast_verlet, &reference_link_cells, &reference_all_pairs,
    &reference_no_contacts, NULL};

MODEL_NAMED(dem_method)

/* --- integrator ----------------------------------------------------------- */

const struct integrator integrators_velocity_verlet = {
    .name = "velocity-verlet",
    .what = "second order without damping; forces computed once a step",
    .equations = "LS section 4.2",
    .function = "rows_advance",
    .keys = {clumps_keys},
    .first = 0.5,
    .last = 0.5,
};

const struct integrator integrators_symplectic_euler = {
    .name = "symplectic-euler",
    .what = "first order; its energy error stays bounded",
    .equations = "LS section 4.2",
    .function = "rows_advance",
    .first = 1.0,
};

/* --- implicit drag -------------------------------------------------------- */

double implicit_drag_gain(double x)
{
    return x > 0.0 ? -expm1(-x) / x : 1.0;
}

const struct integrator *const integrators[] = {
    &integrators_velocity_verlet, &integrators_symplectic_euler,
    &integrators_heun, &integrators_adaptive_heun, NULL};

MODEL_NAMED(integrator)
