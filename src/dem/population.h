/* population.h -- insertion and removal of particles in the coupled step.
 * Chapter "Insertion, removal and energy".
 *
 * Between two steps of the loop, sources insert particles and sinks remove them
 * (population/population.h).
 */
#ifndef DEM_POPULATION_H
#define DEM_POPULATION_H

#include "base/state.h"
#include "dem/box_domain.h"
#include "dem/dem.h"

/* Totals of inserted and removed particles. */
struct population_totals {
    long inserted, removed; /* [-] */
    double mass_in;         /* [kg] */
    double mass_out;        /* [kg] */
    double momentum_in[3];  /* [N s] of the inserted particles */
    double momentum_out[3]; /* [N s] of the removed particles */
    long waiting;           /* [-] particles due, without a free position */
};

struct population;

struct population_functions {
    /* Between two steps of the loop: first mark, then remove if any were
     * marked, then insert.
     *
     * Marks the particles that are removed before a step of dt [s], and adds
     * them to the totals. Returns their number. */
    int (*mark)(struct population *l, const struct particles *ps, double dt);
    /* Removes the marked particles. The others keep their tangential
     * displacements. */
    void (*remove)(struct population *l, struct dem *dem);
    /* Inserts the particles that are due at time t [s]. They follow the others,
     * from the returned index on. */
    int (*insert)(struct population *l, struct particles *ps, struct dem *dem,
                  double t);
    /* Visits the totals and what the sources have inserted (state.h). */
    void (*state)(struct population *l, struct state *s);
    void (*free)(struct population *l);
};

struct population {
    const struct population_functions *functions;
    struct box_domain box;
    int n_sources, n_sinks;
    struct insertion *sources;
    struct population_sink *sinks;
    struct population_totals totals;
    int *is_removed; /* [-] 1 for each particle that is to be removed */
    int capacity;    /* [-] entries of it */
};

#endif
