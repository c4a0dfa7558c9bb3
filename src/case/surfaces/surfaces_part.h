/* surfaces_part.h -- surfaces and prescribed particles as a part of a case. */
#ifndef CASE_SURFACES_SURFACES_PART_H
#define CASE_SURFACES_SURFACES_PART_H

#include "case/settings.h"
#include "coupling/simulation.h"

struct case_scales;

/* 0, or 2 after a message. */
int surfaces_part_check(struct settings *s);

/* Prints its lines for `winnow check`. */
void surfaces_part_print(const struct settings *s, const struct case_scales *k);

/* The box of the particles and the numbers of surfaces, before anything is
 * created. */
void surfaces_part_dem_options(const struct settings *s, struct dem_options *o);

/* Creates surfaces before there are particles. */
void surfaces_part_complete(const struct settings *s, struct simulation *sim,
                            struct dem_options *o);
void surfaces_part_free(struct simulation *sim);

/* Whether particles can start where they were placed, and whether prescribed
 * ones exist. 0, or 2 after a message. */
int surfaces_part_place(const struct settings *s, struct particles *ps,
                        const struct dem_options *o);
int surfaces_part_add(const struct settings *s, struct simulation *sim);

#endif
