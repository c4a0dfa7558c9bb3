/* report_accuracy.h -- what the next finer and the next coarser choice would
 * cost, and gain.  Chapter "What accuracy costs". */
#ifndef CASE_REPORT_REPORT_ACCURACY_H
#define CASE_REPORT_REPORT_ACCURACY_H

#include "case/checks/case_scales.h"
#include "case/settings.h"

/* For `winnow check`: for the steps and the cells, the time of the case over
 * that as it stands and, from the order of the schemes that it chooses, the
 * error that the choice contributes. */
void report_accuracy(const struct settings *s, const struct case_scales *k);

#endif
