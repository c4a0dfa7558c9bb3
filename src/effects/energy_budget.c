/* SPDX-License-Identifier: GPL-3.0-or-later */
/* energy_budget.c -- where the energy of the particles goes, in history.csv.
 *
 * Without it, the loops over the contacts have no trace of it; with it, they
 * take half as long again and move the particles to the same bits.
 */
#include "effects/effects.h"

#include <stddef.h>

#include "exchange/simulation.h"

static void *energy_budget_create(struct simulation *sim,
                                  const double *parameters)
{
    (void)parameters;
    dem_keep_energy(sim->dem);
    return NULL;
}

static const struct key keys[] = {
    {"effects.energy_budget", KEY_GROUP, "", "", KEY_OPTIONAL,
     "the energy of the particles, and what each mechanism takes, in history",
     "LS 4.16", "particles"},
    {0}};

const struct effect energy_budget_effect = {
    .name = "energy_budget",
    .what = "where the particles' energy goes",
    .equations = "LS 4.16",
    .function = "energy_collect",
    .keys = keys,
    .create = energy_budget_create};
