/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/history.h"

#include <math.h>

#include "base/vector.h"
#include "record/history_sums.h"
#include "coupling/coupling.h"
#include "coupling/processes.h"

const struct history_table *const history_tables[] = {
    &history_of_bed, &history_population, &history_budget, &history_further,
    NULL};

/* --- physics ------------------------------------------------------------ */

HISTORY_VALUE(now, sim->t)
HISTORY_VALUE(inlet_velocity, fluid_inlet_velocity(sim->fluid))
HISTORY_VALUE(fluid_energy,
              processes_total(sim, fluid_kinetic_energy(sim->fluid)))

/* Component k of a sum over all [N s]. */
static double component(const struct simulation *sim, int k,
                        void (*sum_of)(const struct simulation *, double[3]))
{
    double sum[3];

    sum_of(sim, sum);
    return sum[k];
}

HISTORY_VALUE(momentum_x, component(sim, 0, coupling_total_momentum))
HISTORY_VALUE(momentum_y, component(sim, 1, coupling_total_momentum))
HISTORY_VALUE(momentum_z, component(sim, 2, coupling_total_momentum))
HISTORY_VALUE(unpaid_x, component(sim, 0, coupling_unpaid_impulse))
HISTORY_VALUE(unpaid_y, component(sim, 1, coupling_unpaid_impulse))
HISTORY_VALUE(unpaid_z, component(sim, 2, coupling_unpaid_impulse))
/* --- numerics ----------------------------------------------------------- */

HISTORY_VALUE(cfl, sim->fluid->report.cfl)
HISTORY_VALUE(mass_residual, sim->fluid->report.mass_residual)
HISTORY_VALUE(momentum_residual, sim->fluid->report.momentum_residual)
HISTORY_VALUE(splitting, sim->fluid->report.piso_residual)
HISTORY_VALUE(pressure_iterations, sim->fluid->report.pressure.iterations)
HISTORY_VALUE(momentum_iterations, sim->fluid->report.momentum.iterations)
HISTORY_VALUE(backflow_faces, sim->fluid->report.backflow_faces)
HISTORY_VALUE(flow_substeps, sim->fluid->report.flow_substeps)
HISTORY_VALUE(mean_gradient_x, sim->fluid->mean_gradient[0])
HISTORY_VALUE(mean_gradient_y, sim->fluid->mean_gradient[1])
HISTORY_VALUE(mean_gradient_z, sim->fluid->mean_gradient[2])
HISTORY_VALUE(exchange_residual, sim->coupling->report.exchange_residual)
HISTORY_VALUE(eps_lowest, sim->coupling->report.eps_lowest)
HISTORY_VALUE(capped_cells, averaging_report(sim->averaging)->capped)
HISTORY_VALUE(substeps, sim->coupling->report.substeps)
HISTORY_VALUE(max_overlap, sim->dem_report.max_overlap)
HISTORY_VALUE(contacts, sim->dem_report.contacts)
HISTORY_VALUE(rebuilds, (double)sim->dem_report.rebuilds)

static double relabelled(const struct simulation *sim)
{
    return vector_length(sim->fluid->relabelled);
}

static double shortest_time(const struct simulation *sim)
{
    const double t = sim->coupling->report.shortest_time;
    return t < HUGE_VAL ? t : 0.0; /* no particle has one */
}

enum {
    F = HISTORY_FLUID,
    P = HISTORY_PARTICLES,
    C = HISTORY_COUPLING,
    D = HISTORY_MEAN_GRADIENT,
    N = HISTORY_PARTS
};

static const struct history_column columns[] = {
    {"time [s]", now, 0},
    {"pressure_drop [Pa]", history_pressure_drop, F},
    {"bed_weight [Pa]", history_bed_weight, P},
    {"buoyant_weight [Pa]", history_buoyant_weight, C},
    {"inlet_velocity [m/s]", inlet_velocity, F},
    {"kinetic_energy_fluid [J]", fluid_energy, F},
    {"kinetic_energy_particles [J]", history_particle_energy, P},
    {"rotational_energy_particles [J]", history_spin_energy, P},
    {NULL, NULL, 0}};

static const struct history_column further[] = {
    {"granular_temperature [m2/s2]", history_granular_temperature, P},
    {"mean_height [m]", history_mean_height, P},
    {"mean_fall_velocity [m/s]", history_mean_fall, P},
    {"momentum_x [N s]", momentum_x, 0},
    {"momentum_y [N s]", momentum_y, 0},
    {"momentum_z [N s]", momentum_z, 0},
    {"unpaid_impulse_x [N s]", unpaid_x, C},
    {"unpaid_impulse_y [N s]", unpaid_y, C},
    {"unpaid_impulse_z [N s]", unpaid_z, C},
    {"max_cfl [-]", cfl, F},
    {"max_overlap [-]", max_overlap, P},
    {"contacts [-]", contacts, P},
    {"list_rebuilds [-]", rebuilds, P},
    {"eps_f_lowest [-]", eps_lowest, C},
    {"capped_cells [-]", capped_cells, C},
    {"substeps [-]", substeps, C},
    {"shortest_relaxation_time [s]", shortest_time, C},
    {"mass_residual [-]", mass_residual, F},
    {"momentum_residual [-]", momentum_residual, F},
    {"piso_splitting [-]", splitting, F},
    {"exchange_residual [-]", exchange_residual, C},
    {"relabelled_momentum [N s]", relabelled, C},
    {"pressure_iterations [-]", pressure_iterations, F},
    {"momentum_iterations [-]", momentum_iterations, F},
    {"backflow_faces [-]", backflow_faces, F},
    {"mean_gradient_x [Pa/m]", mean_gradient_x, D},
    {"mean_gradient_y [Pa/m]", mean_gradient_y, D},
    {"mean_gradient_z [Pa/m]", mean_gradient_z, D},
    {"flow_substeps [-]", flow_substeps, N},
    {NULL, NULL, 0}};

/* 1 if the pressure has a mean gradient, given or adapted. */
static int is_driven(const struct fluid *fl)
{
    for (int k = 0; k < 3 && fl != NULL; k++)
        if (fl->options.mean_gradient[k] != 0.0 || fl->options.keeps_flow[k])
            return 1;
    return 0;
}

const struct history_table history_of_bed = {.columns = columns};
const struct history_table history_further = {.columns = further};

int history_applies(const struct history_table *t,
                    const struct history_column *c,
                    const struct simulation *sim)
{
    return (t->applies == NULL || t->applies(sim)) &&
           (!(c->needs & F) || sim->fluid != NULL) &&
           (!(c->needs & D) || is_driven(sim->fluid)) &&
           (!(c->needs & N) ||
            (sim->fluid != NULL && sim->fluid->options.cfl > 0.0)) &&
           (!(c->needs & P) || sim->particles != NULL) &&
           (!(c->needs & C) || sim->coupling != NULL);
}
