/* case_population.h -- sources and sinks of particles, out of the settings. */
#ifndef CASE_CASE_POPULATION_H
#define CASE_CASE_POPULATION_H

#include "coupling/simulation.h"
#include "dem/population/population.h"
#include "case/settings.h"

/* Are they possible? 0, or 2 after a message. */
int case_population_check(const struct settings *s);

/* How many particles the sources may add to those of the start. */
int case_population_count(const struct settings *s);

/* The smallest of a material that will come [m], 0 if none; the largest of
 * all. */
double case_population_smallest(const struct settings *s, int material);
double case_population_largest(const struct settings *s);

/* All of it; NULL with *code 0 if the case names neither, and with *code 2
 * after a message if a file is wrong. */
struct population *case_population_create(const struct settings *s,
                                          const struct box_domain *box,
                                          int *code);

/* Whether spheres that are due have found no room yet. */
int case_population_waits(const struct simulation *sim);

/* Says which sources have spheres that are due and found no room. */
void case_population_report(const struct simulation *sim);

#endif
