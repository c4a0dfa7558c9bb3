/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/case_cost.h"

/* What one core was seen to do in the Mueller bed, busy with other work beside
 * it: 9.0e6 particle steps a second with Hertz's law, 7.7e6 with the linear
 * one, and 5.1e5 cell steps with all that the coupling needs. */
static const double particle_steps_per_second = 8e6;
static const double cell_steps_per_second = 5e5;

double case_cost_of(const struct case_scales *k, int flow)
{
    const double steps = k->end / k->dt;

    return steps * k->dem_steps * k->particles / particle_steps_per_second +
           steps * k->cells * flow / cell_steps_per_second;
}

double case_cost_seconds(const struct settings *s)
{
    const struct case_scales k = case_scales_of(s);

    return case_cost_of(&k, s->has.fluid);
}
