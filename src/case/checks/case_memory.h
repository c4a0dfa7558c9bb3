/* case_memory.h -- the memory that a case needs, and whether the machine has
 * it.
 *
 * It is counted before anything is made, from the numbers of cells and of
 * particles: a case that cannot fit is refused at once, before the machine
 * begins to swap.
 */
#ifndef CASE_CHECKS_CASE_MEMORY_H
#define CASE_CHECKS_CASE_MEMORY_H

#include "case/settings.h"

/* About what cells and particles take [byte]. */
double case_memory_bytes(const struct settings *s);

/* 0; or 2 after a message if these and `more` [byte] beside them are beyond
 * what the machine has, or the particles beyond what can be numbered. */
int case_memory_check(const struct settings *s, double more);

/* Whether the machine can list this many pairs of particles, which this key
 * [m] asks for: 0, or 2 after a message. */
int case_memory_check_pairs(const struct settings *s, const char *key,
                            double pairs);

#endif
