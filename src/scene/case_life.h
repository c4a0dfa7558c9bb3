/* case_life.h -- sources and sinks of particles, out of the settings. */
#ifndef CASE_LIFE_H
#define CASE_LIFE_H

#include "exchange/simulation.h"
#include "particles/life.h"
#include "scene/settings.h"

/* Are they possible? 0, or 2 after a message. */
int case_life_check(const struct settings *s);

/* How many particles the sources may add to those of the start. */
int case_life_count(const struct settings *s);

/* The smallest of a material that will come [m], 0 if none; the largest of
 * all. */
double case_life_smallest(const struct settings *s, int material);
double case_life_largest(const struct settings *s);

/* All of it; NULL with *code 0 if the case names neither, and with *code 2
 * after a message if a file is wrong. */
struct life *case_life_create(const struct settings *s,
                              const struct domain *box, int *code);

/* Says which sources have spheres that are due and found no room. */
void case_life_report(const struct simulation *sim);

#endif
