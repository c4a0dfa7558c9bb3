/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_fluid.h"

#include "case/build_boundaries.h"
#include "case/case_mesh.h"
#include "case/models.h"
#include "coupling/coupling.h"

int build_two_way(const struct settings *s)
{
    return settings_has(s, "exchange") &&
           models_value(coupling_directions,
                        settings_text(s, "exchange.coupling"));
}

/* The mean gradient or the mean flow in periodic directions. */
static void read_mean_flow(const struct settings *s, struct fluid_options *o)
{
    if (settings_has(s, "fluid.mean_gradient"))
        settings_vector(s, "fluid.mean_gradient", o->mean_gradient);
    if (!settings_has(s, "fluid.mean_flow")) return;
    settings_vector(s, "fluid.mean_flow", o->mean_flow);
    case_mesh_periodic(s, o->keeps_flow);
}

struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim)
{
    const int shared = settings_has(s, "effects.pressure_gradient");
    struct fluid_options o = {
        .rho = settings_real(s, "fluid.density"),
        .mu = settings_real(s, "fluid.viscosity"),
        .dt = sim->dt,
        .cfl = settings_real_or(s, "fluid.cfl", 0.0),
        .convection =
            convection_scheme_named(settings_text(s, "fluid.convection")),
        .time = time_scheme_named(settings_text(s, "fluid.time")),
        .blend = settings_real(s, "fluid.blend"),
        .velocity_gradient =
            velocity_gradient_schemes[0] == NULL
                ? NULL /* there is no such key without a scheme */
                : velocity_gradient_scheme_named(
                      settings_text(s, "fluid.gradient")),
        .outer_correctors = settings_int(s, "fluid.outer_correctors"),
        .continuity = (enum continuity)models_value(
            fluid_continuity_forms, settings_text(s, "fluid.continuity")),
        .correctors = settings_int(s, "fluid.correctors"),
        .p_relative_tolerance = settings_real(s, "fluid.p_relative_tolerance"),
        .u_tolerance = settings_real(s, "fluid.u_tolerance"),
        .piso_tolerance = settings_real(s, "fluid.piso_tolerance"),
        .tolerance = settings_real(s, "fluid.tolerance"),
        .coupled = build_two_way(s),
        .pressure_shared =
            build_two_way(s) && shared &&
            models_value(coupling_forms, settings_text(s, "exchange.model")),
        .boundaries = sim->boundaries};
    read_mean_flow(s, &o);
    return o;
}

int build_fluid(const struct settings *s, struct simulation *sim)
{
    sim->boundaries = build_boundaries(s, sim->mesh);
    if (sim->boundaries == NULL) return 2;
    const struct fluid_options o = build_fluid_options(s, sim);
    sim->fluid = fluid_create(sim->mesh, &o);
    return 0;
}
