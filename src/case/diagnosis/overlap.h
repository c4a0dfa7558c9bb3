/* overlap.h -- the deepest overlap of two particles.
 * Chapter "Particles and contact". */
#ifndef CASE_DIAGNOSIS_OVERLAP_H
#define CASE_DIAGNOSIS_OVERLAP_H

#include "coupling/simulation.h"

/* Describes the deepest overlap, its two partners and its place, as one clause
 * of a sentence. */
enum { OVERLAP_TEXT = 256 };
void overlap_describe(const struct simulation *sim, char text[OVERLAP_TEXT]);

/* Warns of an overlap deeper than expected, where *told is 0, which becomes 1.
 */
void overlap_warn(const struct simulation *sim, int *told);

#endif
