/* explain.h -- `winnow explain`: which equations a case switches on. */
#ifndef EXPLAIN_H
#define EXPLAIN_H

#include "scene/settings.h"

/* Prints on stdout every equation that is on, by key, with the function that
 * evaluates it, and then what is off. Returns the exit code, 0. */
int explain_case(const struct settings *s);

#endif
