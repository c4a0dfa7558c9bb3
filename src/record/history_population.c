/* SPDX-License-Identifier: GPL-3.0-or-later */
/* history_population.c -- columns of insertion and removal.
 * Chapter "Insertion, removal and energy". */
#include "record/history.h"

#include "coupling/population/replacement.h"
#include "dem/population/population.h"
#include "output/summary.h"

/* Component k [N s]. */
static double brought(const struct simulation *sim, int k)
{
    double sum[3];

    replacement_momentum(sim, sum);
    return sum[k];
}

HISTORY_VALUE(replaced_momentum_x, brought(sim, 0))
HISTORY_VALUE(replaced_momentum_y, brought(sim, 1))
HISTORY_VALUE(replaced_momentum_z, brought(sim, 2))

HISTORY_VALUE(particles, sim->particles->n)
HISTORY_VALUE(inserted, (double)sim->population->totals.inserted)
HISTORY_VALUE(removed, (double)sim->population->totals.removed)
HISTORY_VALUE(waiting, (double)sim->population->totals.waiting)
HISTORY_VALUE(mass_in, sim->population->totals.mass_in)
HISTORY_VALUE(mass_out, sim->population->totals.mass_out)
HISTORY_VALUE(replaced, sim->fluid->replaced)

static const struct history_column columns[] = {
    {"particles [-]", particles, 0},
    {"particles_in [-]", inserted, 0},
    {"particles_out [-]", removed, 0},
    {"particles_waiting [-]", waiting, 0},
    {"mass_in [kg]", mass_in, 0},
    {"mass_out [kg]", mass_out, 0},
    {"momentum_brought_x [N s]", replaced_momentum_x, 0},
    {"momentum_brought_y [N s]", replaced_momentum_y, 0},
    {"momentum_brought_z [N s]", replaced_momentum_z, 0},
    {"fluid_replaced [kg]", replaced, HISTORY_COUPLING},
    {NULL, NULL, 0}};

static int history_population_applies(const struct simulation *sim)
{
    return sim->population != NULL;
}

static void history_population_summarize(const struct simulation *sim,
                                         struct summary *f)
{
    if (sim->population == NULL) return;
    summary_count(f, "particles_in", sim->population->totals.inserted);
    summary_count(f, "particles_out", sim->population->totals.removed);
    summary_count(f, "particles_waiting", sim->population->totals.waiting);
}

const struct history_table history_population = {
    columns, history_population_applies, history_population_summarize};
