/* arrays.h -- the arrays of a part of a simulation, as its visit lists them.
 * Chapter "Past one machine".
 *
 * What is saved of the fluid and of the particles (base/state.h) is also what
 * ranks must exchange: the same visit tells both.
 */
#ifndef DISTRIBUTED_RANKS_ARRAYS_H
#define DISTRIBUTED_RANKS_ARRAYS_H

#include "coupling/simulation.h"

enum { ARRAYS_MOST = 160, ARRAYS_NAME = 64 };

struct arrays {
    int n;
    struct state_array at[ARRAYS_MOST]; /* the path is not set */
    char name[ARRAYS_MOST][ARRAYS_NAME];
};

/* Rows are those of one particle, and of all cells or faces. */
void arrays_of_particles(struct particles *ps, struct arrays *a);
void arrays_of_fluid(struct fluid *fl, struct arrays *a);

/* 1 if the name is one of the words of the list. */
int arrays_named(const char *name, const char *words);

#endif
