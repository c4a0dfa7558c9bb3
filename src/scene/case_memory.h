/* case_memory.h -- the memory that a case will take, and whether there is so
 * much.
 *
 * It is counted before anything is made, from the numbers of cells and of
 * particles: a case that cannot fit is told so at once, and not by a machine
 * that stands still.
 */
#ifndef CASE_MEMORY_H
#define CASE_MEMORY_H

#include "scene/settings.h"

/* About what cells and particles take [byte]. */
double case_memory_bytes(const struct settings *s);

/* 0; or 2 after a message if these and `more` [byte] beside them are beyond
 * what the machine has, or the particles beyond what can be numbered. */
int case_memory_check(const struct settings *s, double more);

#endif
