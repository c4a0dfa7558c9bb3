/* report_cohesion.h -- the attractions of a case in numbers. */
#ifndef CASE_REPORT_REPORT_COHESION_H
#define CASE_REPORT_REPORT_COHESION_H

#include "case/settings.h"

/* For `winnow check`: how strong each is, and whether a step of dt [s] resolves
 * it. d [m] and density [kg/m^3] are of the smallest sphere, speed [m/s] is
 * that of an impact. */
void report_cohesion(const struct settings *s, double d, double density,
                     double dt, double speed);

#endif
