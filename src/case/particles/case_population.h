/* case_population.h -- sources and sinks of particles, sizes of beds and placed
 * spheres that overlap: what a case says about them.
 * Chapter "Insertion, removal and energy".
 */
#ifndef CASE_PARTICLES_CASE_POPULATION_H
#define CASE_PARTICLES_CASE_POPULATION_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "dem/bed.h"
#include "dem/population/sizes.h"

/* Reads the files of the sources, and completes their options. 0, or 2 after a
 * message. */
int case_population_check(struct settings *s);
void case_population_release(struct settings *s);

/* The sizes of the bed, where they are not all equal. */
void case_population_bed_sizes(const struct settings *s, struct bed_options *b);

/* How many particles may be inserted after the start. */
int case_population_count(const struct settings *s);

/* Their smallest and largest diameter [m], of one material or, if it is
 * negative, of all; 0 if there are none. */
struct case_diameters {
    double min, max;
};
struct case_diameters case_population_diameters(const struct settings *s,
                                                int material);

/* Whether particles can start where they were placed; may move them. 0, or 2
 * after a message. */
int case_population_place(const struct settings *s, struct particles *ps,
                          const struct dem_options *o);

/* Adds sources and sinks to the particles that there are; the simulation
 * borrows their distributions and lists. */
void case_population_add(const struct settings *s, struct simulation *sim);

/* Inserts what is due before the first step, so that the start has it. 0, or 2
 * after a message. */
int case_population_start(const struct settings *s, struct simulation *sim);

/* Says which sources have spheres that are due and found no room. */
void case_population_report_waiting(const struct simulation *sim);

/* 1 if a signal ended the insertion of the last step early: it then differs
 * from that of a run without the signal. */
int case_population_is_cut_short(const struct simulation *sim);

#endif
