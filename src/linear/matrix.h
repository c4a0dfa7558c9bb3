/* matrix.h -- sparse matrices, by rows (csr) and by links (ldu).
 * Chapter "Linear solvers".
 */
#ifndef LINEAR_MATRIX_H
#define LINEAR_MATRIX_H

#include "linear/faces.h"

/* --- csr ------------------------------------------------------------------ */

/* A sparse matrix whose pattern is a list of links.
 *
 * Link l joins two unknowns, owner[l] and neighbour[l], and stands for the two
 * entries (owner, neighbour) and (neighbour, owner). The rows are stored one
 * after the other (compressed sparse rows), so that a product gathers: one
 * thread sums each row, in ascending columns, and the result has the same bits
 * for any number of threads. The diagonal is stored separately.
 *
 *     (A x)_i = diag_i x_i + sum_e a_e x_(col_e),  start_i <= e < start_(i+1)
 *
 * Every link has its own two entries, even where two links join the same pair
 * (a periodic row of two cells) or join a cell to itself (a periodic row of
 * one). The matrix is filled by writing a[upper[l]] and a[lower[l]], and by
 * adding to diag. */

struct csr {
    int n, n_links;
    int *start;   /* [-] n + 1; the entries of row i are a[start[i]] ... */
    int *col;     /* [-] 2 n_links; ascending within a row */
    double *a;    /* 2 n_links; entries off the diagonal */
    double *diag; /* n */
    int *upper;   /* [-] a[upper[l]] is the entry (owner, neighbour) */
    int *lower;   /* [-] a[lower[l]] is the entry (neighbour, owner) */
};

/* The pattern of these links with all coefficients zero. */
struct csr *csr_create(int n, int n_links, const int *owner,
                       const int *neighbour);

/* Makes A a matrix of diffusion: the entry -g[l] for each link l, except for
 * one that joins a cell to itself, and a diagonal such that the row sums are
 * `sums`. */
void csr_set_diffusion(struct csr *A, const double *g, const double *sums);

/* y = A x. x and y do not overlap, here and below. */
void csr_multiply(const struct csr *A, const double *x, double *y);

/* y = A x for m fields side by side, x[m * i + k]: each coefficient is read
 * once for all fields. */
void csr_multiply_many(const struct csr *A, int m, const double *x, double *y);

/* Rows first .. last - 1 of the same product, for a caller that uses them while
 * they are still in the cache; but each field has its own diagonal, diag[m * i
 * + k], in place of A->diag. Without diag (NULL) the product has no diagonal
 * part. */
void csr_rows_each(int first, int last, const struct csr *A, int m,
                   const double *diag, const double *x, double *y);

/* --- ldu ------------------------------------------------------------------ */

/* A matrix with two numbers a link, for three components at a time.
 *
 * upper[l] is the entry (owner, neighbour), lower[l] the entry (neighbour,
 * owner): assembly writes both arrays link by link, in memory order. Where
 * links form contiguous ranges the product loops over these ranges and is
 * vectorised; elsewhere it loops over rows, with a csr matrix that ldu_update
 * fills.
 *
 *     (A x)_i,k = d_i,k x_i,k + sum of upper or lower times x_j,k
 *
 * Each component k has its own diagonal, or all have the same. The order of the
 * terms in a row is fixed, so the result has the same bits for any number of
 * threads. */

struct ldu {
    int n, n_links;
    int diagonals; /* [-] numbers of the diagonal a row: 3, or 1 for all */
    double *upper, *lower;            /* n_links */
    const struct face_pieces *pieces; /* borrowed; NULL: products by rows */
    struct csr *rows;                 /* if so; else NULL */
};

/* pieces: those of these links, possibly followed by further ones; or NULL. */
struct ldu *ldu_create(int n, int n_links, const int *owner,
                       const int *neighbour, const struct face_pieces *pieces);

/* The caller calls this after writing upper and lower. */
void ldu_update(struct ldu *A);

/* sum[i] = the entries of row i, for first <= i < last. */
void ldu_row_sums(int first, int last, const struct ldu *A, double *sum);

/* Rows first .. last - 1 of y = A x, where x and y do not overlap, for a caller
 * that uses them while they are still in the cache. Without diag (NULL) the
 * product has no diagonal part. */
void ldu_rows(int first, int last, const struct ldu *A, const double *diag,
              const double *x, double *y);

/* The part of the diagonal alone, with y of the first row at y[0]. */
void ldu_diagonal_rows(int first, int last, const struct ldu *A,
                       const double *diag, const double *x, double *y);

#endif
