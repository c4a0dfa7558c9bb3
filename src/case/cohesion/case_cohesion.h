/* case_cohesion.h -- the attractions that a case names. */
#ifndef CASE_CASE_COHESION_H
#define CASE_CASE_COHESION_H

#include "dem/attraction.h"
#include "case/settings.h"

/* All of them, to be released with free(), and how many; NULL if none. */
struct attraction *case_cohesion_create(const struct settings *s, int *n);

/* Whether the parameters of all effects are possible: 0, or 2 after one
 * message. */
int case_cohesion_check(const struct settings *s);

#endif
