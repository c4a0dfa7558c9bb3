/* explain.h -- `winnow explain`: which equations a case switches on. */
#ifndef CASE_REPORT_EXPLAIN_H
#define CASE_REPORT_EXPLAIN_H

#include "case/settings.h"

/* Prints on stdout every equation that is on, by key, with the function that
 * evaluates it, and then what is off. Returns the exit code, 0. */
int explain_case(const struct settings *s);

#endif
