/* shares.h -- particles shared out among the cells around them.  Chapter 8.
 *
 *     field_c = (1 / V_c) sum_i w_ic q_i      [XS11 3.2, 3.5a, 3.7, 3.8, 3.12]
 *     q_i = sum_c w_ic field_c                [XS11 3.9, 3.12]
 *
 * A method brings a rule for the weights of one particle, which add up to one
 * [XS11 3.4]; the loops over particles and cells are the same for all of them
 * and stand here. The bits do not depend on the number of threads.
 */
#ifndef SHARES_H
#define SHARES_H

#include "averaging/hosts.h"
#include "averaging/stencil.h"

/* The cells near a host: cell host + step[e], with its centre at (dx[e],
 * dy[e], dz[e]) from the host's. Entry 0 is the host itself. */
struct around {
    int host, n;
    int first; /* [-] entry 0 among those of the stencil */
    const int *step;
    const double *dx, *dy, *dz; /* [m] */
};

/* How one particle is shared out. weigh writes the weights [-] of particle i,
 * whose offset from its host's centre is h->offset[3 * i], on the entries and
 * returns 1; or it returns 0, and the host takes all. */
struct shares_rule {
    int (*weigh)(const void *state, int i, const struct around *near,
                 double *w);
    const void *state; /* borrowed */
    int keep;          /* 1: weights are dear and few; they are found once for
                          each shares_bind, and those that are not 0 kept */
};

struct shares;

/* reach [m] and to: which cells are near, see stencil.h. The hosts are
 * borrowed; at most so many fields in a call. */
struct shares *shares_create(const struct hosts *h, double reach,
                             enum stencil_to to, int fields,
                             struct shares_rule rule);
void shares_free(struct shares *s);

/* Looks for the cells near anew, if the reach is not enough: a larger particle
 * has come. */
void shares_extend(struct shares *s, double reach);

/* To be called when particles have moved, if weights are kept. */
void shares_bind(struct shares *s);

/* The cells near host c. */
struct around shares_around(const struct shares *s, int c);

/* Borrowed; another one after shares_extend. */
const struct stencil *shares_stencil(const struct shares *s);

/* Returns how many particles went to their host alone. */
int shares_spread(const struct shares *s, int m, const double *q,
                  double *field);
void shares_gather(const struct shares *s, int m, const double *field,
                   double *q);

#endif
