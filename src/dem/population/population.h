/* population.h -- insertion and removal of particles.
 * Chapter "Insertion, removal and energy".
 *
 * Between two steps of the loop the sources insert particles and the sinks
 * remove them. An id is used once, so a removed particle is never confused with
 * a later one. The other particles keep their tangential displacements.
 */
#ifndef DEM_POPULATION_POPULATION_H
#define DEM_POPULATION_POPULATION_H

#include "base/state.h"
#include "dem/box_domain.h"
#include "dem/dem.h"
#include "dem/population/insertion.h"

/* Removes particles whose centre is in a box, or that would touch a side of the
 * domain within the next step and so leave through it. */
struct population_sink {
    double lo[3], hi[3]; /* [m] */
    int side;            /* [-] -1: the box; else 2 k the lower, 2 k + 1 the
                            upper side of direction k */
};

/* As a case writes it. */
struct sink_setup {
    struct population_sink of; /* without side */
    int has_from, has_to;      /* [-] 1: of.lo, of.hi are given */
    const char *side;          /* "none", or one of mesh_sides */
};

/* Totals of inserted and removed particles. */
struct population_totals {
    long inserted, removed; /* [-] */
    double mass_in;         /* [kg] */
    double mass_out;        /* [kg] */
    double momentum_in[3];  /* [N s] of the inserted particles */
    double momentum_out[3]; /* [N s] of the removed particles */
    long waiting;           /* [-] particles due, without a free position */
};

struct population {
    struct box_domain box;
    int n_sources, n_sinks;
    struct insertion *sources;
    struct population_sink *sinks;
    struct population_totals totals;
    int *is_removed; /* [-] 1 for each particle that is to be removed */
};

/* Sources and sinks are all 0, for the caller to fill in. */
struct population *population_create(const struct box_domain *box,
                                     int n_sources, int n_sinks);

/* Between two steps of the loop: first mark, then dem_remove with is_removed if
 * any were marked, then insert.
 *
 * Marks the particles that are removed before a step of dt [s], and adds them
 * to the totals. Returns their number. */
int population_mark(struct population *l, const struct particles *ps,
                    double dt);
/* Inserts the particles that are due at time t [s]. They follow the others,
 * from the returned index on. */
int population_insert(struct population *l, struct particles *ps,
                      struct dem *dem, double t);

/* Visits the totals and what the sources have inserted (state.h). */
void population_state(struct population *l, struct state *s);

#endif
