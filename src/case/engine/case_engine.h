/* case_engine.h -- whether one machine or several compute a case.
 * Chapter "Past one machine". */
#ifndef CASE_ENGINE_CASE_ENGINE_H
#define CASE_ENGINE_CASE_ENGINE_H

#include "case/settings.h"

struct case_scales;

extern const struct key case_engine_keys[];

/* 0, or 2 after a message. */
int case_engine_check(const struct settings *s);

/* Prints its lines for `winnow check`. */
void case_engine_print(const struct settings *s, const struct case_scales *k);

/* Whether this program can compute the case: 0, or 2 after a message. */
int case_engine_check_run(const struct settings *s);

#endif
