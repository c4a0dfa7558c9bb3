/* SPDX-License-Identifier: GPL-3.0-or-later */
/* energy_budget.c -- the energy budget of the particles, in history.csv.
 *
 * A case without it runs contact loops that are compiled without its code; with
 * it they take half as long again. The motion of the particles has the same
 * bits with and without it.
 */
#include "coupling/effects.h"

#include <stddef.h>

#include "coupling/simulation.h"

static void *energy_budget_create(struct simulation *sim,
                                  const double *parameters)
{
    (void)parameters;
    dem_start_energy_budget(sim->dem);
    return NULL;
}

static const struct key keys[] = {
    {"effects.energy_budget", KEY_GROUP, "", "", KEY_OPTIONAL,
     "energy of the particles, and its loss by each mechanism, in history.csv",
     "LS 4.16", "particles",
     .divided = "it is kept in the contact loop, which is LAMMPS'"},
    {0}};

const struct effect energy_budget_effect = {
    .name = "energy_budget",
    .what = "energy budget of the particles",
    .equations = "LS 4.16",
    .function = "budget_collect",
    .keys = {keys},
    .create = energy_budget_create,
};
