/* standing.h -- which variant is the case as it stands. */
#ifndef STUDY_STANDING_H
#define STUDY_STANDING_H

#include "study/choices.h"

/* The variant whose values the case has itself, defaults included; what is set
 * for all runs counts as the case's. -1 if none is. */
int standing_variant(const char *case_file, const struct choices *c);

#endif
