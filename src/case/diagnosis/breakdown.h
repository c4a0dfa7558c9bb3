/* breakdown.h -- why a computation broke down. */
#ifndef CASE_DIAGNOSIS_BREAKDOWN_H
#define CASE_DIAGNOSIS_BREAKDOWN_H

#include "coupling/simulation.h"

/* Where, when, what, and a remedy, in one paragraph. */
enum { BREAKDOWN_TEXT = 512 };
void breakdown_describe(const struct simulation *sim,
                        char text[BREAKDOWN_TEXT]);

#endif
