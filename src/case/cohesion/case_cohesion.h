/* case_cohesion.h -- the attractions that a case names. */
#ifndef CASE_COHESION_CASE_COHESION_H
#define CASE_COHESION_CASE_COHESION_H

#include "dem/attraction.h"
#include "case/settings.h"

/* All of them, to be released with free(), and how many; NULL if none. */
struct attraction *case_cohesion_create(const struct settings *s, int *n);

#endif
