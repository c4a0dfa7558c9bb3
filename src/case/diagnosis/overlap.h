/* case_overlap.h -- how deep particles may overlap.
 * Chapter "Particles and contact". */
#ifndef CASE_CASE_OVERLAP_H
#define CASE_CASE_OVERLAP_H

#include "coupling/simulation.h"
#include "case/settings.h"

/* The limits of the case for its particles. */
void case_overlap_limit(const struct settings *s, struct simulation *sim);

/* Describes the deepest overlap, its two partners and its place, as one clause
 * of a sentence. */
enum { CASE_OVERLAP_TEXT = 256 };
void case_overlap_describe(const struct simulation *sim,
                           char text[CASE_OVERLAP_TEXT]);

/* Warns of an overlap deeper than expected, where *told is 0, which becomes 1.
 */
void case_overlap_warn(const struct simulation *sim, int *told);

/* How deep a placed sphere may be in a wall of the box, over its diameter [-]:
 * 0.01, and up to its centre where particles.overlaps is "allow". */
double case_overlap_in_wall(const struct settings *s);

#endif
