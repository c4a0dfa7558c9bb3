/* breakdown.h -- the message when a computation breaks down. */
#ifndef CASE_BREAKDOWN_H
#define CASE_BREAKDOWN_H

#include "coupling/simulation.h"

enum { BREAKDOWN_TEXT = 512 };

/* One paragraph: where, when, what, and a remedy. */
void breakdown_describe(const struct simulation *sim,
                        char text[BREAKDOWN_TEXT]);

#endif
