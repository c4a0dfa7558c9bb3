/* output_check.h -- what a case says in the group output, checked. */
#ifndef CASE_CHECKS_OUTPUT_CHECK_H
#define CASE_CHECKS_OUTPUT_CHECK_H

#include "case/settings.h"

/* 0 if the case asks for what there is; else 2 after a message. */
int output_check(const struct settings *s);

#endif
