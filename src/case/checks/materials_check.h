/* materials_check.h -- the names of the materials of a case. */
#ifndef CASE_CHECKS_MATERIALS_CHECK_H
#define CASE_CHECKS_MATERIALS_CHECK_H

#include "case/settings.h"

/* Each is given once, and what is made of a material names one that there is:
 * 0, or 2 after one message. */
int materials_check(const struct settings *s);

/* A name that the case gives at `path` must be one of the materials': 0, or 2
 * after one message. */
int materials_check_name(const struct settings *s, const char *path,
                         const char *name);

/* 1 if any two of them, or one with itself, resist rolling. */
int materials_check_rolling(const struct settings *s);

#endif
