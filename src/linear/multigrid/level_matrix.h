/* level_matrix.h -- the matrices of the levels of multigrid.
 * Chapter "Linear solvers".
 */
#ifndef LINEAR_MULTIGRID_LEVEL_MATRIX_H
#define LINEAR_MULTIGRID_LEVEL_MATRIX_H

#include "linear/matrix.h"

/* --- symmetric ------------------------------------------------------------ */

/* A matrix by diagonals (symmetric.c), with the entry -g[l] for link l and a
 * diagonal such that the row sums are those given. The cycle works in single
 * precision, with the matrix times `unit`, and the outer iteration in double
 * precision. */

enum { SYMMETRIC_BANDS = 6 }; /* at most */

/* Links first, first + 1, ... with successive places in a band or, -1, among
 * the links of rest; or, -2, each from a cell to itself. */
struct link_run {
    int first, n, band, place;
};

struct symmetric {
    int n, n_links;
    int n_bands, distance[SYMMETRIC_BANDS];
    int pad; /* [-] zeros before and after a vector or band, so that i - d and
                i + d need no test */
    double unit; /* [1/coefficient] the numbers in single precision are times
                    this, to be of order one */
    float *diag, *inverse;          /* the diagonal and, padded, one over it */
    float *band[SYMMETRIC_BANDS];   /* padded */
    double *exact_diag;             /* the same in double and in the unit of */
    double *exact[SYMMETRIC_BANDS]; /* the matrix; NULL unless exact */
    int n_runs;
    struct link_run *run; /* ascending; they cover all links */
    struct csr *rest;     /* NULL if there is nothing left */
    int *rest_row;  /* [-] the rows of rest that are not empty, ascending */
    int *rest_from; /* [-] n + 1: rest_row[rest_from[i]] is the first >= i */
};

/* exact: the matrix will be multiplied in double. */
struct symmetric *symmetric_create(int n, int n_links, const int *owner,
                                   const int *neighbour, int exact);

/* A vector of n zeros that the matrix can be applied to; it belongs to S. */
float *symmetric_vector(struct symmetric *S);

/* Sets the coefficient g of each link and the row sums. */
void symmetric_fill(struct symmetric *S, const double *g, const double *sums,
                    double unit);

/* With A times unit: r = b - A x, and y = alpha x + beta w + gamma D^-1 (b - A
 * x). x is such a vector; y may be w. */
void symmetric_residual(const struct symmetric *S, const float *b,
                        const float *x, float *r);
void symmetric_relax(const struct symmetric *S, const float *b, const float *x,
                     float alpha, const float *w, float beta, float gamma,
                     float *y);

/* The same for rows first .. last - 1. */
void symmetric_residual_rows(int first, int last, const struct symmetric *S,
                             const float *b, const float *x, float *r);
void symmetric_relax_rows(int first, int last, const struct symmetric *S,
                          const float *b, const float *x, float alpha,
                          const float *w, float beta, float gamma, float *y);

/* y = A x in double; returns x.y. */
double symmetric_multiply(const struct symmetric *S, const double *x,
                          double *y);

/* The weights of the two stages of Chebyshev smoothing. */
struct level_smoothing {
    float first, previous, second; /* [-] */
};

/* All that a cycle does on a level on its way down, and up again: y from zero
 * by the two stages, and r = b - A y; y plus that of its parents on the coarser
 * level, and the two stages, by way of x. Return 0 if this is not quicker than
 * stage by stage, and nothing has been done (symmetric_stages.c). */
int symmetric_descend(const struct symmetric *S, const float *b,
                      struct level_smoothing w, float *y, float *r);
int symmetric_ascend(const struct symmetric *S, const float *b,
                     struct level_smoothing w, const int *parent,
                     const float *coarse, float *x, float *y);

static inline int symmetric_lesser(int a, int b)
{
    return a < b ? a : b;
}

/* --- dense ---------------------------------------------------------------- */

/* Direct solution of a small symmetric system.
 *
 * A = L D L^T, L with a unit diagonal. If a pivot is zero within rounding (in a
 * singular system, such as that of the pressure between walls), its unknown is
 * set to zero, because a division would only amplify rounding errors. */

struct dense {
    int n;
    double *a; /* n columns of n numbers, of which only the lower part is used;
                  after factoring, L below the diagonal */
    double *inverse; /* one over the pivots, 0 for a pivot that vanished */
};

struct dense *dense_create(int n);

/* Factors the matrix, which the caller has filled, in place. */
void dense_factor(struct dense *D);

/* x = A^-1 b; x may be b. */
void dense_solve(const struct dense *D, const double *b, double *x);

#endif
