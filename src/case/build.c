/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build.h"

#include "base/alloc.h"
#include "coupling/effects.h"
#include "coupling/coupling.h"
#include "case/build_fluid.h"
#include "case/build_particles.h"
#include "case/case_mesh.h"
#include "case/population/case_population.h"
#include "case/resolved/case_bodies.h"
#include "case/case_steps.h"
#include "case/fill.h"

/* --- coupling ----------------------------------------------------------- */

struct averaging_options build_averaging_options(const struct settings *s)
{
    struct averaging_options o = s->averaging;

    if (o.delta_05 > 0.0) o.bandwidth = averaging_bandwidth(o.delta_05);
    o.fields = 4;
    if (o.method->own_keys != NULL)
        fill_numbers(s, o.method->own_keys, o.own, MODEL_NUMBERS);
    return o;
}

static int create_averaging(const struct settings *s, struct simulation *sim)
{
    const struct averaging_options o = build_averaging_options(s);

    sim->averaging = averaging_create(o.method, sim->mesh, sim->particles, &o);
    return sim->averaging == NULL ? 2 : 0;
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

/* --- effects ------------------------------------------------------------ */

void build_effects(const struct settings *s, struct simulation *sim)
{
    double numbers[EFFECT_NUMBERS];

    for (int i = 0; effects[i] != NULL; i++)
        if (fill_effect_numbers(s, effects[i], numbers))
            effects_add(sim, effects[i], effects[i]->create(sim, numbers));
}

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
        *code = create_averaging(s, sim);
        if (*code == 0) build_coupling(s, sim);
    }
    if (*code == 0) {
        build_effects(s, sim);
        *code = case_bodies_add(s, sim);
        if (*code == 0 && with_bed) case_population_start(sim);
        if (*code == 0) return sim;
    }
    build_free(sim);
    return NULL;
}

struct simulation *build_simulation(const struct settings *s, int *code)
{
    return build_for_run(s, 1, NULL, code);
}
