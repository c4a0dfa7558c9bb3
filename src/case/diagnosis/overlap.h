/* overlap.h -- the deepest overlap of two particles.
 * Chapter "Particles and contact". */
#ifndef CASE_DIAGNOSIS_OVERLAP_H
#define CASE_DIAGNOSIS_OVERLAP_H

#include "case/settings.h"
#include "coupling/simulation.h"

/* Describes the deepest overlap, its two partners and its place, as one clause
 * of a sentence. */
enum { OVERLAP_TEXT = 256 };
void overlap_describe(const struct simulation *sim, char text[OVERLAP_TEXT]);

/* Warns once in a run of an overlap deeper than expected (run_part.h). */
void *overlap_create(const struct settings *s, const struct simulation *sim);
void overlap_warn(void *told, const struct simulation *sim);
void overlap_free(void *told, const struct simulation *sim);

#endif
