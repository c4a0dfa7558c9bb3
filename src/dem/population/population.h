/* population.h -- insertion and removal of particles.
 * Chapter "Insertion, removal and energy".
 *
 * Between two steps of the loop the sources insert particles and the sinks
 * remove them. An id is used once, so a removed particle is never confused with
 * a later one. The other particles keep their tangential displacements.
 */
#ifndef DEM_POPULATION_POPULATION_H
#define DEM_POPULATION_POPULATION_H

#include "dem/population.h"
#include "dem/population/insertion.h"

/* Removes particles whose centre is in a box, or that would touch a side of the
 * domain within the next step and so leave through it. */
struct population_sink {
    double lo[3], hi[3]; /* [m] */
    int side;            /* [-] -1: the box; else 2 k the lower, 2 k + 1 the
                            upper side of direction k */
};

/* Sources and sinks are all 0, for the caller to fill in. */
struct population *population_create(const struct box_domain *box,
                                     int n_sources, int n_sinks);
void population_free(struct population *l);

/* The functions of the population (dem/population.h). */
int population_mark(struct population *l, const struct particles *ps,
                    double dt);
void population_remove(struct population *l, struct dem *dem);
int population_insert(struct population *l, struct particles *ps,
                      struct dem *dem, double t);

/* Visits what was inserted and removed (state.h). */
void population_state(struct population *l, struct state *s);

#endif
