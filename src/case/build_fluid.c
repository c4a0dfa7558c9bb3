/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/build_fluid.h"

#include "case/build_boundaries.h"
#include "case/case_mesh.h"

struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim)
{
    struct fluid_options o = s->fluid;

    o.dt = sim->dt;
    o.coupled = s->exchange.two_way;
    o.pressure_shared =
        o.coupled && s->effects.pressure_gradient && s->exchange.form_a;
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
