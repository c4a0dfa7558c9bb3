/* materials_check.h -- the names of the materials of a case. */
#ifndef CASE_CHECKS_MATERIALS_CHECK_H
#define CASE_CHECKS_MATERIALS_CHECK_H

#include "case/settings.h"

/* Each is given once, and what is made of a material names one that there is:
 * 0, or 2 after one message. */
int materials_check(const struct settings *s);

#endif
