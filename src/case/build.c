/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build.h"

#include "base/alloc.h"
#include "coupling/effects.h"
#include "coupling/coupling.h"
#include "case/build_fluid.h"
#include "case/build_particles.h"
#include "case/case_mesh.h"
#include "case/resolved/case_bodies.h"
#include "case/case_steps.h"
#include "case/models.h"
#include "case/table_numbers.h"

/* --- coupling ----------------------------------------------------------- */

static double bandwidth_of(const struct settings *s)
{
    return settings_has(s, "averaging.delta_05")
               ? averaging_bandwidth(settings_real(s, "averaging.delta_05"))
               : settings_real_or(s, "averaging.bandwidth", 0.0);
}

struct averaging_options build_averaging_options(const struct settings *s)
{
    const struct averaging_method *const method =
        averaging_method_named(settings_text(s, "averaging.method"));
    struct averaging_options o = {
        .bandwidth = bandwidth_of(s),
        .scheme = settings_text(s, "averaging.scheme"),
        .steps = settings_has(s, "averaging.steps")
                     ? settings_int(s, "averaging.steps")
                     : 0, /* the default of the methods */
        .tolerance = settings_real(s, "averaging.tolerance"),
        .cap = settings_real_or(s, "averaging.cap", 0.0),
        .vary = settings_text(s, "averaging.bandwidth_variation"),
        .fields = 4};
    if (method->own_keys != NULL)
        table_numbers(s, method->own_keys, o.own, MODEL_NUMBERS);
    return o;
}

static int create_averaging(const struct settings *s, struct simulation *sim)
{
    struct averaging_options o = build_averaging_options(s);
    struct averaging_region region[BUILD_MAX_REGIONS];

    o.n_regions = settings_length(s, "averaging.regions");
    o.regions = region;
    for (int i = 0; i < o.n_regions; i++) {
        static const char *const list = "averaging.regions";
        settings_item_vector(s, list, i, "low", region[i].low);
        settings_item_vector(s, list, i, "high", region[i].high);
        region[i].bandwidth = settings_item_real(s, list, i, "bandwidth");
    }
    sim->averaging = averaging_create(
        averaging_method_named(settings_text(s, "averaging.method")), sim->mesh,
        sim->particles, &o);
    return sim->averaging == NULL ? 2 : 0;
}

struct drag_law build_drag_law(const struct settings *s)
{
    struct drag_law law = *drag_law_named(settings_text(s, "exchange.drag"));

    if (law.own_keys != NULL)
        table_numbers(s, law.own_keys, law.own, MODEL_NUMBERS);
    return law;
}

void build_coupling(const struct settings *s, struct simulation *sim)
{
    const struct drag_law law = build_drag_law(s);
    const struct coupling_options o = {
        .law = &law,
        .treatment = (enum treatment)models_value(
            coupling_treatments, settings_text(s, "exchange.treatment")),
        .slip_integration = (enum slip_integration)models_value(
            coupling_slip_integrations,
            settings_text(s, "exchange.slip_integration")),
        .interpolation =
            interpolation_named(settings_text(s, "averaging.interpolation")),
        .substeps = settings_int(s, "exchange.substeps"),
        .two_way = build_two_way(s)};
    sim->coupling = coupling_create(sim, &o);
}

/* --- effects ------------------------------------------------------------ */

void build_effects(const struct settings *s, struct simulation *sim)
{
    double numbers[16];

    for (int i = 0; effects[i] != NULL; i++) {
        const struct effect *const e = effects[i];
        if (!settings_has(s, e->keys[0]->path)) continue;
        table_numbers(s, e->keys[0], numbers, 16);
        effects_add(sim, e, e->create(sim, numbers));
    }
}

struct simulation *build_for_run(const struct settings *s, int with_bed,
                                 const struct bed_saver *saver, int *code)
{
    struct simulation *const sim = alloc_zeroed(1, sizeof *sim);

    *code = 0;
    sim->mesh = case_mesh_create(s);
    sim->dt = case_steps_length(s);
    sim->dem_steps = case_steps_within(s);
    if (settings_has(s, "particles"))
        *code = build_particles(s, sim, with_bed, saver);
    if (*code == 0 && s->has.fluid) *code = build_fluid(s, sim);
    if (*code == 0 && settings_has(s, "exchange")) {
        *code = create_averaging(s, sim);
        if (*code == 0) build_coupling(s, sim);
    }
    if (*code == 0) {
        build_effects(s, sim);
        *code = case_bodies_add(s, sim);
        if (*code == 0) return sim;
    }
    build_free(sim);
    return NULL;
}

struct simulation *build_simulation(const struct settings *s, int *code)
{
    return build_for_run(s, 1, NULL, code);
}
