/* ldu.h -- a matrix with two numbers a link, for three components at a time.
 *
 * Chapter "Linear solvers".
 *
 * upper[l] is the entry (owner, neighbour), lower[l] the entry (neighbour,
 * owner): assembly writes both arrays link by link, in memory order. Where
 * links form contiguous ranges the product loops over these ranges and is
 * vectorised; elsewhere it loops over rows, with a csr matrix that ldu_update
 * fills.
 *
 *     (A x)_i,k = d_i,k x_i,k + sum of upper or lower times x_j,k
 *
 * Each component k has its own diagonal. The order of the terms in a row is
 * fixed, so the result has the same bits for any number of threads.
 */
#ifndef LINEAR_LDU_H
#define LINEAR_LDU_H

#include "linear/csr.h"
#include "linear/faces.h"

struct ldu {
    int n, n_links;
    double *upper, *lower;            /* n_links */
    const struct face_pieces *pieces; /* borrowed; NULL: products by rows */
    struct csr *rows;                 /* if so; else NULL */
};

/* pieces: those of these links, possibly followed by further ones; or NULL. */
struct ldu *ldu_create(int n, int n_links, const int *owner,
                       const int *neighbour, const struct face_pieces *pieces);
void ldu_free(struct ldu *A);

/* The caller calls this after writing upper and lower. */
void ldu_update(struct ldu *A);

/* sum[i] = the entries of row i, for first <= i < last. */
void ldu_row_sums(int first, int last, const struct ldu *A, double *sum);

/* Rows first .. last - 1 of y = A x, where x and y do not overlap, for a caller
 * that uses them while they are still in the cache. Without diag3 (NULL) the
 * product has no diagonal part. */
void ldu_rows(int first, int last, const struct ldu *A, const double *diag3,
              const double *x, double *y);

#endif
