/* breakdown.h -- what to say when a computation breaks down. */
#ifndef BREAKDOWN_H
#define BREAKDOWN_H

#include "exchange/simulation.h"

enum { BREAKDOWN_TEXT = 512 };

/* Where, when, what, and what to try: one paragraph. */
void breakdown_describe(const struct simulation *sim,
                        char text[BREAKDOWN_TEXT]);

#endif
