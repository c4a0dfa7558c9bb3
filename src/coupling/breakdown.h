/* breakdown.h -- why a computation broke down. */
#ifndef COUPLING_BREAKDOWN_H
#define COUPLING_BREAKDOWN_H

#include "coupling/simulation.h"

/* Where, when, what, and a remedy, in one paragraph. */
enum { BREAKDOWN_TEXT = 512 };
void breakdown_describe(const struct simulation *sim,
                        char text[BREAKDOWN_TEXT]);

/* 1 if an overlap is deeper than expected; breakdown_warn: says so, once in a
 * run, as *told says. */
int breakdown_overlaps(const struct simulation *sim);
void breakdown_warn(int *told, const struct simulation *sim);

#endif
