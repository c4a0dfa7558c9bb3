/* case_cost.h -- the time that a case will take. */
#ifndef CASE_CHECKS_CASE_COST_H
#define CASE_CHECKS_CASE_COST_H

#include "case/checks/case_scales.h"
#include "case/settings.h"

/* About the time of one core, without settling [s]. */
double case_cost_seconds(const struct settings *s);

/* The same of a case with these scales; flow: 1 if it has a fluid. */
double case_cost_of(const struct case_scales *k, int flow);

#endif
