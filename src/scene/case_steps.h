/* case_steps.h -- how a case divides its time.
 *
 * The steps of the loop are the fluid's; without a fluid they are the time
 * between two rows of the history. The particles divide each of them, and the
 * loop looks at its results after whole numbers of them.
 */
#ifndef CASE_STEPS_H
#define CASE_STEPS_H

#include "scene/settings.h"

/* 0, or 2 after a message: a number of steps that cannot be counted, or a run
 * that ends before its first step does. */
int case_steps_check(const struct settings *s);

/* [s] of the loop. */
double case_steps_length(const struct settings *s);

/* The particle steps in one of the loop, at least 1: as many as make them no
 * longer than the case asks; 0 without particles. */
int case_steps_within(const struct settings *s);

/* The steps of the loop until output.end. */
long case_steps_until_end(const struct settings *s);

/* The steps of the loop nearest to an interval that the case gives, at least
 * 1. */
long case_steps_between(const struct settings *s, const char *path);

#endif
