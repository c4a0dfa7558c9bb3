/* overlap.h -- the deepest overlap of two particles.
 * Chapter "Particles and contact". */
#ifndef CASE_DIAGNOSIS_OVERLAP_H
#define CASE_DIAGNOSIS_OVERLAP_H

#include "coupling/simulation.h"

/* Describes the deepest overlap, its two partners and its place, as one clause
 * of a sentence. */
enum { OVERLAP_TEXT = 256 };
void overlap_describe(const struct simulation *sim, char text[OVERLAP_TEXT]);

/* 1 if an overlap is deeper than expected. */
int overlap_is_deeper(const struct simulation *sim);

/* Warns once in a run, as *told says, of an overlap deeper than expected. */
void overlap_warn(int *told, const struct simulation *sim);

#endif
