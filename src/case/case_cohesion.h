/* case_cohesion.h -- the attractions that a case names. */
#ifndef CASE_CASE_COHESION_H
#define CASE_CASE_COHESION_H

#include "dem/attraction.h"
#include "case/settings.h"

/* All of them, to be released with free(), and how many; NULL if none. */
struct attraction *case_cohesion_create(const struct settings *s, int *n);

/* For validate_case: 0, or 2 after one message. */
int case_cohesion_check(const struct settings *s);

/* For `winnow check`: how strong each is, and whether a step of dt [s] resolves
 * it. d [m] and density [kg/m^3] are of the smallest sphere, speed [m/s] is
 * that of an impact. */
void case_cohesion_print(const struct settings *s, double d, double density,
                         double dt, double speed);

#endif
