/* level.h -- one level of multigrid: its matrix, its vectors, and how its
 * unknowns and links are made of those of the finer level.  Chapter 7.
 */
#ifndef LEVEL_H
#define LEVEL_H

#include "linear/csr.h"
#include "linear/graph.h"
#include "linear/symmetric.h"

/* What many things are summed into: the things list[start[i]] .. of i, each
 * times its share. */
struct members {
    int *start, *list;
    double *share; /* [-] */
};

struct level {
    int n, n_links;
    struct symmetric *A;
    double *g;            /* coefficient of each link: minus the entry */
    double *sums;         /* row sums of A: what is not between unknowns */
    float *b, *r;         /* right-hand side, residual */
    float *x, *y;         /* two stages of the solution, padded */
    int *parent;          /* [-] aggregate of each unknown; owned */
    struct members links; /* of the finer level in each link; the share is the
                             length of the finer over that of the coarser */
    struct members cells; /* of the finer level in each unknown; the share is
                             the same for what leads to a wall, 1 inside */
};

/* A level with the unknowns and links of a graph. */
void level_init(struct level *v, const struct graph *g, int finest);
void level_release(struct level *v);

/* Ties v, the level of coarse, to the finer level. */
void level_tie(struct level *v, const struct graph *fine,
               const struct graph *coarse, const int *parent,
               const int *bundle);

/* The coefficients and row sums: on the finest level those given, on the others
 * summed from the finer level. unit as in symmetric_fill. */
void level_take_over(struct level *v, const double *g, const double *sums,
                     double unit);
void level_sum_up(struct level *v, const struct level *fine, double unit);

/* The right-hand side of v is the residual of the finer level, summed; the
 * solution of v is added to the solution y of the finer level. */
void level_restrict(struct level *v, const struct level *fine);
void level_prolong(const struct level *v, struct level *fine);

#endif
