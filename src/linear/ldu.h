/* ldu.h -- a matrix with two numbers a link, for three components at a time.
 * Chapter 7.
 *
 * upper[l] is the entry (owner, neighbour), lower[l] the entry (neighbour,
 * owner): what makes the matrix writes them link by link, as they lie. Where
 * links stand in runs the product goes by runs, at vector speed; else it goes
 * by rows, with a csr that ldu_update fills.
 *
 *     (A x)_i,k = d_i,k x_i,k + sum of upper or lower times x_j,k
 *
 * Each component k has a diagonal of its own. The order of a row's terms is
 * fixed, and so are the bits for any number of threads.
 */
#ifndef LDU_H
#define LDU_H

#include "linear/csr.h"
#include "linear/runs.h"

struct ldu {
    int n, n_links;
    double *upper, *lower;   /* n_links */
    const struct runs *runs; /* borrowed; NULL: go by rows */
    struct csr *rows;        /* if so; else NULL */
};

/* runs: of these links, more may follow; or NULL. */
struct ldu *ldu_create(int n, int n_links, const int *owner,
                       const int *neighbour, const struct runs *runs);
void ldu_free(struct ldu *A);

/* To be called when upper and lower have been written. */
void ldu_update(struct ldu *A);

/* sum[i] = the entries of row i, for first <= i < last. */
void ldu_row_sums(int first, int last, const struct ldu *A, double *sum);

/* y = A x, x and y apart; diag3 NULL: without diagonal. And the rows first ..
 * last - 1 of it, for a caller who goes on with them while they are cached. */
void ldu_multiply(const struct ldu *A, const double *diag3, const double *x,
                  double *y);
void ldu_rows(int first, int last, const struct ldu *A, const double *diag3,
              const double *x, double *y);

#endif
