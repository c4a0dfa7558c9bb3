/* case_averaging.h -- what a case says of the averaging, held against the rest
 * of it. */
#ifndef CASE_CHECKS_CASE_AVERAGING_H
#define CASE_CHECKS_CASE_AVERAGING_H

#include "case/settings.h"

/* 0, or 2 after a message. */
int case_averaging_check(const struct settings *s);

#endif
