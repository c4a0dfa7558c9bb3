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

struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim)
{
    const int shared = settings_has(s, "effects.pressure_gradient");
    struct fluid_options o = s->fluid;

    o.dt = sim->dt;
    o.coupled = build_two_way(s);
    o.pressure_shared =
        o.coupled && shared &&
        models_value(coupling_forms, settings_text(s, "exchange.model"));
    o.boundaries = sim->boundaries;
    if (o.has_mean_flow) case_mesh_periodic(s, o.keeps_flow);
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
