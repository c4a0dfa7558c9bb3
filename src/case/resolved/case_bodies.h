/* case_bodies.h -- the group `bodies` of a case.  Chapter "Resolving the
 * grains". */
#ifndef CASE_RESOLVED_CASE_BODIES_H
#define CASE_RESOLVED_CASE_BODIES_H

#include "case/part.h"

extern const struct case_part case_bodies;
extern const struct key case_bodies_keys[];

#endif
