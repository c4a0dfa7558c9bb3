/* symmetric.h -- what the files of a symmetric matrix by diagonals share.
 * Chapter "Linear solvers".
 */
#ifndef LINEAR_MULTIGRID_SYMMETRIC_H
#define LINEAR_MULTIGRID_SYMMETRIC_H

#include "linear/csr.h"
#include "linear/multigrid/level_matrix.h"

enum { SYMMETRIC_BANDS = 6 }; /* at most */

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
    int *band_of_link,
        *index_in_band; /* [-] of link l: its band and place there; or -1 and
           its link in rest; -2: joins a cell to itself */
    struct csr *rest;   /* NULL if there is nothing left */
    int *rest_row;      /* [-] the rows of rest that are not empty, ascending */
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
