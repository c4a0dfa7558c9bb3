/* weights.h -- weights of particles in the cells around them.
 * Chapter "Averaging".
 *
 *     field_c = (1 / V_c) sum_i w_ic q_i      [XS11 3.2, 3.5a, 3.7, 3.8, 3.12]
 *     q_i = sum_c w_ic field_c                [XS11 3.9, 3.12]
 *
 * A method provides a rule for the weights of one particle, which add up to one
 * [XS11 3.4]; the loops over particles and cells are common to all methods and
 * are in this module. The result does not depend on the number of threads.
 */
#ifndef AVERAGING_KERNEL_WEIGHTS_H
#define AVERAGING_KERNEL_WEIGHTS_H

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "averaging/kernel/stencil.h"

/* The cells near a cell c: their numbers are c + index_offset[e], and their
 * centres are at (dx[e], dy[e], dz[e]) from that of c. Entry 0 is c itself. */
struct neighbourhood {
    int cell, n;
    const int *index_offset;
    const double *dx, *dy, *dz; /* [m] */
};

/* Weights w [-] of one particle in n cells, as offsets from its own cell. */
struct weight_list {
    int n;
    const int *index_offset;
    const double *w;
};

/* The rule of a method. weigh writes the weights [-] of particle i, whose
 * offset from the centre of its cell is h->offset[3 * i], for all entries and
 * returns 1; or it returns 0, and the whole particle is assigned to its own
 * cell. */
struct weights_rule {
    int (*weigh)(const void *state, int i, const struct neighbourhood *near,
                 double *w);
    const void *state; /* borrowed */
    /* The weights of particle h->particle[a], for a method that stores them;
     * NULL: weigh is called at every use. */
    struct weight_list (*list)(const void *state, int a);
};

struct weights;

/* reach [m] and to: which cells are near, see stencil.h. The cells are
 * borrowed; at most so many fields in a call. */
struct weights *weights_create(const struct cell_of_particle *h, double reach,
                               enum stencil_to to, int fields,
                               struct weights_rule rule);
void weights_free(struct weights *s);

/* The cells near cell c. */
struct neighbourhood weights_around(const struct weights *s, int c);

/* Borrowed. */
const struct stencil *weights_stencil(const struct weights *s);

/* Estimate of the memory for the neighbourhoods of all cells before they are
 * found [byte]; d [m] is the largest diameter. The mesh may be an outline. */
double weights_bytes(const struct averaging_method *method,
                     const struct mesh *mesh, double d,
                     const struct averaging_options *o);

/* Spreading, and its adjoint. weights_spread returns the number of particles
 * that were assigned to their own cell alone; 0 if the rule has a list. */
int weights_spread(const struct weights *s, int m, const double *q,
                   double *field);
void weights_gather(const struct weights *s, int m, const double *field,
                    double *q);

#endif
