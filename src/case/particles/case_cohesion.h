/* case_cohesion.h -- the attractions that a case names. */
#ifndef CASE_PARTICLES_CASE_COHESION_H
#define CASE_PARTICLES_CASE_COHESION_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "dem/attraction.h"

/* All of them, to be released with free(), and how many; NULL if none. */
struct attraction *case_cohesion_create(const struct settings *s, int *n);

/* 0, or 2 after a message. */
int case_cohesion_check(const struct settings *s);
/* The same for the memory of the list of pairs, after all else of the particles
 * is checked. */
int case_cohesion_check_pairs(const struct settings *s);

/* The key of an attraction between particles and the walls of the box, and of
 * nothing else, that the case names; NULL: it names none. */
const char *case_cohesion_of_box(const struct settings *s);

/* Gives a simulation its attractions, before there are particles; free releases
 * them. */
int case_cohesion_complete(const struct settings *s, struct simulation *sim,
                           struct dem_options *o);
void case_cohesion_free(struct simulation *sim);

#endif
