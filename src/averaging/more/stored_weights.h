/* stored_weights.h -- weights that are computed once and stored.
 * Chapter "Further averaging methods".
 *
 * Where the weights of a particle are few and take long to compute, as the
 * volumes that a sphere has in each cell, they are computed once after the
 * particles have moved, and those that are not 0 are stored, particle after
 * particle in the order of their cells.
 */
#ifndef AVERAGING_MORE_STORED_WEIGHTS_H
#define AVERAGING_MORE_STORED_WEIGHTS_H

#include "averaging/kernel/weights.h"

struct stored_weights {
    int *start;        /* [-] the weights of particle h->particle[a] are */
    int *index_offset; /* [-] start[a] .. start[a + 1] - 1 of the cells */
    double *w;         /* [-] and of the weights */
    int capacity;      /* [-] of these two */
    int unsupported;   /* [-] particles assigned to their own cell alone */
};

/* For as many particles as there may be at most; released by the second. */
struct stored_weights stored_weights_of(int capacity);
void stored_weights_release(struct stored_weights *k);

/* Computes the weights of all particles in the cells near theirs by the
 * function weigh of the rule. */
void stored_weights_fill(struct stored_weights *k,
                         const struct cell_of_particle *h,
                         const struct weights *near,
                         const struct weights_rule *rule);

/* Those of particle h->particle[a], for the function list of a rule. */
struct weight_list stored_weights_list(const struct stored_weights *k, int a);

#endif
