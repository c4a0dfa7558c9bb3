/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_cost.h"

#include "case/case_mesh.h"
#include "case/case_population.h"
#include "case/case_steps.h"

/* What one core was seen to do in the Mueller bed, busy with other work beside
 * it: 9.0e6 particle steps a second with Hertz's law, 7.7e6 with the linear
 * one, and 5.1e5 cell steps with all that the coupling needs. */
static const double particle_steps_per_second = 8e6;
static const double cell_steps_per_second = 5e5;

double case_cost_particles(const struct settings *s)
{
    if (!settings_has(s, "particles")) return 0.0;
    return case_population_count(s) +
           (settings_has(s, "particles.bed")
                ? settings_int(s, "particles.bed.count")
                : settings_length(s, "particles.place"));
}

double case_cost_seconds(const struct settings *s)
{
    const double steps = settings_real(s, "output.end") / case_steps_length(s);
    const double particle_steps =
        steps * case_steps_within(s) * case_cost_particles(s);
    const int flow = settings_has(s, "fluid");

    return particle_steps / particle_steps_per_second +
           steps * case_mesh_cells(s) * flow / cell_steps_per_second;
}
