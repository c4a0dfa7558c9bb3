/* case_population.h -- sources and sinks of particles, sizes of beds and placed
 * spheres that overlap: what a case says about them.
 * Chapter "Insertion, removal and energy".
 */
#ifndef CASE_POPULATION_CASE_POPULATION_H
#define CASE_POPULATION_CASE_POPULATION_H

#include "base/key.h"

extern const struct key case_population_keys[];

#endif
