/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/case_file.h"
#include "case/settings.h"
#include "case/particles/case_population.h"
#include "case/resolved/case_bodies.h"
#include "case/schema.h"
#include "case/particles/case_surfaces.h"
#include "coupling/coupling.h"
#include "coupling/effects.h"
#include "coupling/processes.h"
#include "fluid/inlet_profile.h"

/* --- coupling ------------------------------------------------------------- */

struct averaging_options build_averaging_options(const struct settings *s)
{
    struct averaging_options o = s->averaging;

    if (o.delta_05 > 0.0) o.bandwidth = averaging_bandwidth(o.delta_05);
    o.fields = 4;
    if (o.method->own_keys != NULL)
        fill_numbers(s, o.method->own_keys, o.own, MODEL_NUMBERS);
    return o;
}

struct drag_law build_drag_law(const struct settings *s)
{
    struct drag_law law = *s->exchange.law;

    if (law.own_keys != NULL)
        fill_numbers(s, law.own_keys, law.own, MODEL_NUMBERS);
    return law;
}

void build_coupling(const struct settings *s, struct simulation *sim)
{
    const struct drag_law law = build_drag_law(s);
    struct coupling_options o = s->exchange;

    o.law = &law;
    o.interpolation = s->averaging.interpolation;
    sim->coupling = coupling_create(sim, &o);
}

/* --- effects -------------------------------------------------------------- */

void build_effects(const struct settings *s, struct simulation *sim)
{
    double numbers[EFFECT_NUMBERS];

    for (int i = 0; effects[i] != NULL; i++)
        if (fill_effect_numbers(s, effects[i], numbers))
            effects_create(sim, effects[i], numbers);
}

/* --- the boundaries ------------------------------------------------------- */

/* 1 if both ends of direction k are walls that hold the fluid. */
static int between_walls(const struct settings *s, int k)
{
    for (int i = 0; i < 2; i++) {
        const struct boundary_options *const o =
            settings_side(s, mesh_sides[2 * k + i]);
        if (o == NULL || o->condition->kind != BOUNDARY_NO_SLIP) return 0;
    }
    return 1;
}

/* A message about a key of a side; 0 if there is none. */
static int build_boundaries_wrong(const struct settings *s,
                                  const struct boundary_options *o,
                                  const char *key, const char *why)
{
    char path[SCHEMA_TEXT];

    if (key == NULL) return 0;
    snprintf(path, sizeof path, "%s%s%s", o->key, key[0] != '\0' ? "." : "",
             key);
    return settings_wrong(s, path, "%s", why);
}

/* A case may leave out a symmetry plane of the mesh. */
static int one_boundary(const struct settings *s, const struct mesh *m,
                        const struct patch *p, struct boundary *b)
{
    struct boundary_request r = {.says = settings_side(s, p->name),
                                 .mesh = m,
                                 .patch = p,
                                 .end = s->output.end};
    char wrong[BOUNDARY_TEXT];

    b->kind = r.says != NULL ? r.says->condition->kind : BOUNDARY_SLIP;
    if (r.says == NULL || r.says->condition->build == NULL) return 0;
    for (int k = 0; k < 3; k++)
        r.between_walls[k] = s->poly == NULL && between_walls(s, k);
    if (r.says->file != NULL) r.file = settings_input(s, r.says->file);
    return build_boundaries_wrong(
        s, r.says, r.says->condition->build(&r, b, wrong), wrong);
}

struct boundary *build_boundaries(const struct settings *s,
                                  const struct mesh *m)
{
    struct boundary *const all =
        alloc_zeroed((size_t)m->n_patches, sizeof *all);
    int failed = 0;

    for (int i = 0; i < m->n_patches && !failed; i++)
        failed = one_boundary(s, m, &m->patches[i], &all[i]);
    if (!failed) return all;
    build_boundaries_free(all, m->n_patches);
    return NULL;
}

void build_boundaries_free(struct boundary *all, int n)
{
    for (int i = 0; i < n && all != NULL; i++)
        boundary_release(&all[i]);
    free(all);
}

/* --- before there is a fluid ---------------------------------------------- */

static int check_condition(const struct settings *s, const struct mesh *m,
                           const struct patch *p, int *doubtful)
{
    const struct boundary_options *const o = settings_side(s, p->name);
    const struct boundary_condition *const c = o != NULL ? o->condition : NULL;
    char wrong[BOUNDARY_TEXT];

    if (o == NULL) return 0;
    if (c->is_doubtful != NULL) *doubtful |= c->is_doubtful(o);
    return c->check == NULL
               ? 0
               : build_boundaries_wrong(s, o, c->check(o, m, p, wrong), wrong);
}

int build_boundaries_check(const struct settings *s)
{
    struct mesh *m = case_mesh_outline(s);
    int code = 0, doubtful = 0;

    for (int i = 0; i < m->n_patches && code == 0; i++)
        code = check_condition(s, m, &m->patches[i], &doubtful);
    mesh_free(m);
    if (code != 0 || !doubtful) return code;
    m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m);
    code = all == NULL ? 2 : 0;
    build_boundaries_free(all, m->n_patches);
    mesh_free(m);
    return code;
}

/* --- the velocity over the patch ------------------------------------------ */

/* Of one boundary at one time. */
static void add_shares(const struct mesh *m, const struct patch *p,
                       const struct boundary *b, double t, double *mean,
                       double *peak)
{
    double sum = 0.0, surface = 0.0;

    for (int j = 0; j < p->n; j++) {
        const double area = vector_length(mesh_S(m, p->first + j));
        const double share = boundary_inlet_profile(b, j, t);
        sum += share * area;
        surface += area;
        *peak = fmax(*peak, share);
    }
    *mean = fmax(*mean, sum / surface);
}

void build_boundaries_shares(const struct settings *s, const char *patch,
                             double *mean, double *peak)
{
    const int is_uniform =
        settings_side(s, patch)->profile == &inlet_profile_uniform;
    const double end = s->output.end;

    *mean = *peak = is_uniform ? 1.0 : 0.0;
    if (is_uniform) return;
    struct mesh *const m = case_mesh_create(s);
    struct boundary *const all = build_boundaries(s, m);
    const struct patch *const p = mesh_patch(m, patch);
    for (int i = 0; i <= BOUNDARY_TIMES && all != NULL; i++)
        add_shares(m, p, &all[p - m->patches], end * i / BOUNDARY_TIMES, mean,
                   peak);
    build_boundaries_free(all, m->n_patches);
    mesh_free(m);
}

/* --- the fluid ------------------------------------------------------------ */

struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim)
{
    struct fluid_options o = s->fluid;

    o.dt = sim->dt;
    o.coupled = s->exchange.two_way;
    o.undisturbed = !o.coupled && !s->has.bodies;
    o.pressure_shared =
        o.coupled && s->effects.pressure_gradient && s->exchange.form_a;
    o.boundaries = sim->boundaries;
    if (o.has_mean_flow) case_mesh_periodic(s, o.keeps_flow);
    return o;
}

static int build_fluid(const struct settings *s, struct simulation *sim)
{
    sim->boundaries = build_boundaries(s, sim->mesh);
    if (sim->boundaries == NULL) return 2;
    const struct fluid_options o = build_fluid_options(s, sim);
    sim->fluid = fluid_create(sim->mesh, &o);
    return 0;
}

/* --- the whole ------------------------------------------------------------ */

struct simulation *build_for_run(const struct settings *s, int with_bed,
                                 const struct bed_saver *saver, int *code)
{
    struct simulation *const sim = alloc_zeroed(1, sizeof *sim);

    *code = 0;
    sim->mesh = case_mesh_create(s);
    sim->dt = case_steps_length(s);
    sim->dem_steps = case_steps_within(s);
    if (s->has.particles) *code = build_particles(s, sim, with_bed, saver);
    if (*code == 0 && s->has.fluid) *code = build_fluid(s, sim);
    if (*code == 0 && s->has.exchange) {
        const struct averaging_options o = build_averaging_options(s);
        sim->averaging =
            averaging_create(o.method, sim->mesh, sim->particles, &o);
        *code = sim->averaging == NULL ? 2 : 0;
        if (*code == 0) build_coupling(s, sim);
    }
    if (*code == 0) {
        build_effects(s, sim);
        *code = case_bodies_add(s, sim);
        if (*code == 0 && with_bed) *code = case_population_start(s, sim);
        if (*code == 0) return sim;
    }
    build_free(sim);
    return NULL;
}

struct simulation *build_simulation(const struct settings *s, int *code)
{
    return build_for_run(s, 1, NULL, code);
}

/* --- its end -------------------------------------------------------------- */

void build_free(struct simulation *sim)
{
    if (sim == NULL) return;
    if (sim->processes != NULL) sim->processes->free(sim->processes);
    effects_free(sim);
    owner_free(sim->coupling);
    averaging_free(sim->averaging);
    dem_free(sim->dem);
    case_surfaces_free(sim);
    free(sim->attractions);
    owner_free(sim->population);
    free(sim->materials);
    particles_free(sim->particles);
    owner_free(sim->fluid);
    build_boundaries_free(sim->boundaries,
                          sim->mesh != NULL ? sim->mesh->n_patches : 0);
    mesh_free(sim->mesh);
    free(sim);
}
