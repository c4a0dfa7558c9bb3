/* level_matrix.h -- the matrix of one level of multigrid.
 * Chapter "Linear solvers".
 *
 * It is symmetric, with the entry -g[l] for link l and a diagonal such that the
 * row sums are those given. The cycle works in single precision, with the
 * matrix times `unit`, and the outer iteration in double precision. It is
 * stored by diagonals for speed (symmetric.c); the test compares that with
 * rows.
 */
#ifndef LINEAR_MULTIGRID_LEVEL_MATRIX_H
#define LINEAR_MULTIGRID_LEVEL_MATRIX_H

#include "linear/matrix.h"

/* The weights of the two stages of Chebyshev smoothing. */
struct level_smoothing {
    float first, previous, second; /* [-] */
};

/* How a matrix is stored. `data` is what create returns. */
struct level_matrix_kind {
    const char *name;
    /* exact: the matrix will be multiplied in double. */
    void *(*create)(int n, int n_links, const int *owner, const int *neighbour,
                    int exact);
    void (*free)(void *data);
    /* A vector of n zeros that the matrix can be applied to. */
    float *(*vector)(const void *data);
    void (*vector_free)(const void *data, float *x);
    void (*fill)(void *data, const double *g, const double *sums, double unit);
    /* One over the diagonal times unit. */
    const float *(*inverse)(const void *data);
    /* With A times unit: r = b - A x, and y = alpha x + beta w + gamma D^-1
     * (b - A x). x is such a vector; y may be w. */
    void (*residual)(const void *data, const float *b, const float *x,
                     float *r);
    void (*relax)(const void *data, const float *b, const float *x, float alpha,
                  const float *w, float beta, float gamma, float *y);
    /* y = A x in double; returns x.y. */
    double (*multiply)(const void *data, const double *x, double *y);
    /* All that a cycle does on a level on its way down, and up again: y from
     * zero by the two stages, and r = b - A y; y plus that of its parents on
     * the coarser level, and the two stages, by way of x. Return 0 if this is
     * not quicker than stage by stage, and nothing has been done. NULL: never.
     */
    int (*descend)(const void *data, const float *b,
                   struct level_smoothing weights, float *y, float *r);
    int (*ascend)(const void *data, const float *b,
                  struct level_smoothing weights, const int *parent,
                  const float *coarse, float *x, float *y);
};

/* By diagonals, which the cycle uses; and the plain kind. */
extern const struct level_matrix_kind level_matrix_bands;
extern const struct level_matrix_kind level_matrix_rows;

/* Of a matrix by diagonals: the links that are on none of those stored. */
int symmetric_links_left(const void *data);

/* Direct solution of a small symmetric system.
 *
 * A = L D L^T, L with a unit diagonal. If a pivot is zero within rounding (in a
 * singular system, such as that of the pressure between walls), its unknown is
 * set to zero, because a division would only amplify rounding errors. */

struct dense;

struct dense *dense_create(int n);
void dense_free(struct dense *D);

/* Returns the matrix, n columns of n numbers, of which only the lower part is
 * used. The caller fills it; dense_factor then factors it in place. */
double *dense_matrix(struct dense *D);
void dense_factor(struct dense *D);

/* x = A^-1 b; x may be b. */
void dense_solve(const struct dense *D, const double *b, double *x);

/* --- symmetric ------------------------------------------------------------ */

/* What the files of a symmetric matrix by diagonals share. */

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

static inline int symmetric_lesser(int a, int b)
{
    return a < b ? a : b;
}

/* The functions of a level for rows first .. last - 1. */
void symmetric_residual_rows(int first, int last, const struct symmetric *S,
                             const float *b, const float *x, float *r);
void symmetric_relax_rows(int first, int last, const struct symmetric *S,
                          const float *b, const float *x, float alpha,
                          const float *w, float beta, float gamma, float *y);

/* symmetric_stages.c: the whole way down and up. */
int symmetric_stages_descend(const void *data, const float *b,
                             struct level_smoothing w, float *y, float *r);
int symmetric_stages_ascend(const void *data, const float *b,
                            struct level_smoothing w, const int *parent,
                            const float *coarse, float *x, float *y);

#endif
