/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/history.h"

#include <math.h>

#include "case/history_sums.h"
#include "coupling/coupling.h"
#include "coupling/processes.h"
#include "coupling/replacement.h"
#include "dem/energy.h"
#include "dem/population.h"

/* Most columns are one expression of the simulation. */
#define VALUE(name, expression)                                                \
    static double name(const struct simulation *sim)                           \
    {                                                                          \
        return expression;                                                     \
    }

/* --- physics ------------------------------------------------------------ */

VALUE(now, sim->t)
VALUE(inlet_velocity, fluid_inlet_velocity(sim->fluid))
VALUE(fluid_energy, processes_total(sim, fluid_kinetic_energy(sim->fluid)))

/* Component k of a sum over all [N s]. */
static double component(const struct simulation *sim, int k,
                        void (*sum_of)(const struct simulation *, double[3]))
{
    double sum[3];

    sum_of(sim, sum);
    return sum[k];
}

VALUE(momentum_x, component(sim, 0, coupling_total_momentum))
VALUE(momentum_y, component(sim, 1, coupling_total_momentum))
VALUE(momentum_z, component(sim, 2, coupling_total_momentum))
VALUE(unpaid_x, component(sim, 0, coupling_unpaid_impulse))
VALUE(unpaid_y, component(sim, 1, coupling_unpaid_impulse))
VALUE(unpaid_z, component(sim, 2, coupling_unpaid_impulse))
VALUE(replaced_momentum_x, component(sim, 0, replacement_momentum))
VALUE(replaced_momentum_y, component(sim, 1, replacement_momentum))
VALUE(replaced_momentum_z, component(sim, 2, replacement_momentum))

/* For a simulation with a population (dem/population.h). */
VALUE(particles, sim->particles->n)
VALUE(inserted, (double)sim->population->totals.inserted)
VALUE(removed, (double)sim->population->totals.removed)
VALUE(waiting, (double)sim->population->totals.waiting)
VALUE(mass_in, sim->population->totals.mass_in)
VALUE(mass_out, sim->population->totals.mass_out)
VALUE(replaced, sim->fluid->replaced)

/* The budget of the energy of the particles (dem/energy.h). */
VALUE(normal_springs, dem_energy(sim->dem)->normal)
VALUE(tangential_springs, dem_energy(sim->dem)->tangential)
VALUE(damped_n, dem_energy(sim->dem)->damped_n)
VALUE(damped_t, dem_energy(sim->dem)->damped_t)
VALUE(slid, dem_energy(sim->dem)->slid)
VALUE(released, dem_energy(sim->dem)->released)
VALUE(rolled, dem_energy(sim->dem)->rolled)
VALUE(work, dem_energy(sim->dem)->work)
VALUE(attracted, dem_energy(sim->dem)->attracted)
VALUE(of_walls, dem_energy(sim->dem)->walls)
VALUE(energy_brought, dem_energy(sim->dem)->added)
VALUE(residual_of_energy, energy_residual(dem_energy(sim->dem)))

/* --- numerics ----------------------------------------------------------- */

VALUE(cfl, sim->fluid->report.cfl)
VALUE(mass_residual, sim->fluid->report.mass_residual)
VALUE(momentum_residual, sim->fluid->report.momentum_residual)
VALUE(splitting, sim->fluid->report.piso_residual)
VALUE(pressure_iterations, sim->fluid->report.pressure.iterations)
VALUE(momentum_iterations, sim->fluid->report.momentum.iterations)
VALUE(backflow_faces, sim->fluid->report.backflow_faces)
VALUE(fluid_parts, sim->fluid->report.flow_substeps)
VALUE(mean_gradient_x, sim->fluid->mean_gradient[0])
VALUE(mean_gradient_y, sim->fluid->mean_gradient[1])
VALUE(mean_gradient_z, sim->fluid->mean_gradient[2])
VALUE(exchange_residual, sim->coupling->report.exchange_residual)
VALUE(eps_lowest, sim->coupling->report.eps_lowest)
VALUE(capped_cells, averaging_report(sim->averaging)->capped)
VALUE(substeps, sim->coupling->report.substeps)
VALUE(max_overlap, sim->dem_report.max_overlap)
VALUE(contacts, sim->dem_report.contacts)
VALUE(rebuilds, (double)sim->dem_report.rebuilds)

static double relabelled(const struct simulation *sim)
{
    const double *const r = sim->fluid->relabelled;
    return sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
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
    N = HISTORY_PARTS,
    E = HISTORY_BUDGET,
    L = HISTORY_POPULATION
};

const struct history_column history_columns[] = {
    {"time [s]", now, 0},
    {"pressure_drop [Pa]", history_pressure_drop, F},
    {"bed_weight [Pa]", history_bed_weight, P},
    {"buoyant_weight [Pa]", history_buoyant_weight, C},
    {"inlet_velocity [m/s]", inlet_velocity, F},
    {"kinetic_energy_fluid [J]", fluid_energy, F},
    {"kinetic_energy_particles [J]", history_particle_energy, P},
    {"rotational_energy_particles [J]", history_spin_energy, P},
    {"particles [-]", particles, L},
    {"particles_in [-]", inserted, L},
    {"particles_out [-]", removed, L},
    {"particles_waiting [-]", waiting, L},
    {"mass_in [kg]", mass_in, L},
    {"mass_out [kg]", mass_out, L},
    {"momentum_brought_x [N s]", replaced_momentum_x, L},
    {"momentum_brought_y [N s]", replaced_momentum_y, L},
    {"momentum_brought_z [N s]", replaced_momentum_z, L},
    {"fluid_replaced [kg]", replaced, C | L},
    {"energy_normal_springs [J]", normal_springs, E},
    {"energy_tangential_springs [J]", tangential_springs, E},
    {"lost_in_normal_dashpots [J]", damped_n, E},
    {"lost_in_tangential_dashpots [J]", damped_t, E},
    {"lost_by_sliding [J]", slid, E},
    {"lost_by_tangential_springs [J]", released, E},
    {"lost_by_rolling [J]", rolled, E},
    {"work_of_outside_forces [J]", work, E},
    {"work_of_cohesion [J]", attracted, E},
    {"work_of_walls [J]", of_walls, E},
    {"energy_brought [J]", energy_brought, E},
    {"energy_residual [J]", residual_of_energy, E},
    {"granular_temperature [m2/s2]", history_granular_temperature, P},
    {"mean_height [m]", history_mean_height, P},
    {"mean_fall_velocity [m/s]", history_mean_fall, P},
    {"momentum_x [N s]", momentum_x, 0},
    {"momentum_y [N s]", momentum_y, 0},
    {"momentum_z [N s]", momentum_z, 0},
    {"owed_x [N s]", unpaid_x, C},
    {"owed_y [N s]", unpaid_y, C},
    {"owed_z [N s]", unpaid_z, C},
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
    {"fluid_parts [-]", fluid_parts, N},
    {NULL, NULL, 0}};

/* 1 if the pressure has a mean gradient, given or adapted. */
static int is_driven(const struct fluid *fl)
{
    for (int k = 0; k < 3 && fl != NULL; k++)
        if (fl->options.mean_gradient[k] != 0.0 || fl->options.keeps_flow[k])
            return 1;
    return 0;
}

int history_applies(const struct history_column *c,
                    const struct simulation *sim)
{
    return (!(c->needs & F) || sim->fluid != NULL) &&
           (!(c->needs & D) || is_driven(sim->fluid)) &&
           (!(c->needs & N) ||
            (sim->fluid != NULL && sim->fluid->options.cfl > 0.0)) &&
           (!(c->needs & P) || sim->particles != NULL) &&
           (!(c->needs & C) || sim->coupling != NULL) &&
           (!(c->needs & L) || sim->population != NULL) &&
           (!(c->needs & E) ||
            (sim->dem != NULL && dem_energy(sim->dem) != NULL));
}
