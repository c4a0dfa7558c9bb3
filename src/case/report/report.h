/* report.h -- `winnow check`: a case in derived numbers, before it is run. */
#ifndef CASE_REPORT_REPORT_H
#define CASE_REPORT_REPORT_H

#include "case/settings.h"

/* Prints on stdout what follows from the case: resolution, time scales, chosen
 * steps, cost. Returns the exit code, 0 or 2. */
int report_case(const struct settings *s);

#endif
