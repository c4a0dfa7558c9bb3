/* level.h -- one level of multigrid: its matrix, its vectors, and the map from
 * the unknowns and links of the finer level to its own.
 * Chapter "Linear solvers".
 */
#ifndef LINEAR_MULTIGRID_LEVEL_H
#define LINEAR_MULTIGRID_LEVEL_H

#include "linear/csr.h"
#include "linear/multigrid/graph.h"
#include "linear/multigrid/level_matrix.h"

/* A sum over members: entry i is the sum of the members list[start[i]] ..
 * list[start[i + 1] - 1], each times its weight. */
struct level_members {
    int *start, *list;
    double *weight; /* [-] */
};

struct level {
    int n, n_links;
    const struct level_matrix_kind *kind; /* how A is stored */
    void *A;
    double *g;    /* coefficient of each link: minus the entry */
    double *sums; /* row sums of A: the coefficients to a given value outside */
    float *b, *r; /* right-hand side, residual */
    float *x, *y; /* two stages of the solution, padded */
    int *parent;  /* [-] aggregate of each unknown; owned */
    struct level_members
        links; /* finer links summed into each link; the weight is the length of
                  the finer link over that of the coarser */
    struct level_members
        cells; /* finer unknowns summed into each unknown; the weight is the
                  same ratio of lengths for coefficients to a wall, 1 inside */
};

/* A level with the unknowns and links of a graph. */
void level_init(struct level *v, const struct graph *g, int finest);
void level_release(struct level *v);

/* Sets the map from the finer level to v, the level of the graph `coarse`. */
void level_connect(struct level *v, const struct graph *fine,
                   const struct graph *coarse, const int *parent,
                   const int *bundle);

/* Sets the coefficients and row sums: on the finest level those given, on each
 * coarser level the Galerkin sums over the finer level. unit as in
 * level_matrix.h. */
void level_set_fine(struct level *v, const double *g, const double *sums,
                    double unit);
void level_galerkin_coarsen(struct level *v, const struct level *fine,
                            double unit);

/* The right-hand side of v is the residual of the finer level, summed; the
 * solution of v is added to the solution y of the finer level. */
void level_restrict(struct level *v, const struct level *fine);
void level_prolong(const struct level *v, struct level *fine);

#endif
