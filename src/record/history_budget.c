/* SPDX-License-Identifier: GPL-3.0-or-later */
/* history_budget.c -- columns of the energy budget of the particles.
 * Chapter "Insertion, removal and energy". */
#include "record/history.h"

#include "dem/energy.h"

HISTORY_VALUE(normal_springs, dem_energy(sim->dem)->normal)
HISTORY_VALUE(tangential_springs, dem_energy(sim->dem)->tangential)
HISTORY_VALUE(damped_n, dem_energy(sim->dem)->damped_n)
HISTORY_VALUE(damped_t, dem_energy(sim->dem)->damped_t)
HISTORY_VALUE(slid, dem_energy(sim->dem)->slid)
HISTORY_VALUE(released, dem_energy(sim->dem)->released)
HISTORY_VALUE(rolled, dem_energy(sim->dem)->rolled)
HISTORY_VALUE(work, dem_energy(sim->dem)->work)
HISTORY_VALUE(attracted, dem_energy(sim->dem)->attracted)
HISTORY_VALUE(of_walls, dem_energy(sim->dem)->walls)
HISTORY_VALUE(energy_brought, dem_energy(sim->dem)->added)
HISTORY_VALUE(residual_of_energy, energy_residual(dem_energy(sim->dem)))

static const struct history_column columns[] = {
    {"energy_normal_springs [J]", normal_springs, 0},
    {"energy_tangential_springs [J]", tangential_springs, 0},
    {"lost_in_normal_dashpots [J]", damped_n, 0},
    {"lost_in_tangential_dashpots [J]", damped_t, 0},
    {"lost_by_sliding [J]", slid, 0},
    {"lost_by_tangential_springs [J]", released, 0},
    {"lost_by_rolling [J]", rolled, 0},
    {"work_of_outside_forces [J]", work, 0},
    {"work_of_cohesion [J]", attracted, 0},
    {"work_of_walls [J]", of_walls, 0},
    {"energy_brought [J]", energy_brought, 0},
    {"energy_residual [J]", residual_of_energy, 0},
    {NULL, NULL, 0}};

static int history_budget_applies(const struct simulation *sim)
{
    return sim->dem != NULL && dem_energy(sim->dem) != NULL;
}

const struct history_table history_budget = {.columns = columns,
                                             .applies = history_budget_applies};
