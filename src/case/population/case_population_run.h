/* case_population_run.h -- insertion during a run and after it.
 * Chapter "Insertion, removal and energy". */
#ifndef CASE_POPULATION_CASE_POPULATION_RUN_H
#define CASE_POPULATION_CASE_POPULATION_RUN_H

#include "coupling/simulation.h"

/* Says which sources have spheres that are due and found no room. */
void case_population_run_report(const struct simulation *sim);

/* 1 if a signal ended the insertion of the last step early: it then differs
 * from that of a run without the signal. */
int case_population_run_is_cut_short(const struct simulation *sim);

#endif
