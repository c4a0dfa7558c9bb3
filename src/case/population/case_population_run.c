/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_population_run.c -- insertion during a run and after it.
 * Chapter "Insertion, removal and energy". */
#include "case/population/case_population_run.h"

#include <stdio.h>

#include "base/interrupt.h"
#include "dem/population/population.h"

void case_population_run_report(const struct simulation *sim)
{
    const struct population *const l = sim->population;

    for (int i = 0; l != NULL && i < l->n_sources && sim->steps > 0; i++) {
        const struct insertion *const in = &l->sources[i];
        const long due = insertion_count_due(in, sim->t - sim->dt);
        if (in->n_inserted < due)
            fprintf(
                stderr,
                "winnow: source %d of particles.insert: %ld of the %ld spheres "
                "that were due by t = %g s have found no room; make the region "
                "larger, the rate lower, or let particles leave it sooner\n",
                i, due - in->n_inserted, due, sim->t);
    }
}

int case_population_run_is_cut_short(const struct simulation *sim)
{
    return interrupt_arrived() && sim->population != NULL &&
           sim->population->totals.waiting > 0;
}
