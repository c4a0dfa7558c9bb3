/* case_cost.h -- the time that a case will take. */
#ifndef CASE_CASE_COST_H
#define CASE_CASE_COST_H

#include "case/settings.h"

/* About the time of one core, without settling [s]. */
double case_cost_seconds(const struct settings *s);

#endif
