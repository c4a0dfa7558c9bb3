/* csr.h -- a sparse matrix whose pattern is a list of links.
 * Chapter "Linear solvers".
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
 * adding to diag.
 */
#ifndef LINEAR_CSR_H
#define LINEAR_CSR_H

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
void csr_free(struct csr *A);

/* Makes A a matrix of diffusion: the entry -g[l] for each link l, except for
 * one that joins a cell to itself, and a diagonal such that the row sums are
 * `sums`.
 */
void csr_set_diffusion(struct csr *A, const double *g, const double *sums);

/* y = A x. x and y do not overlap, here and below. */
void csr_multiply(const struct csr *A, const double *x, double *y);

/* y = A x for m fields side by side, x[m * i + k]: each coefficient is read
 * once for all fields. */
void csr_multiply_many(const struct csr *A, int m, const double *x, double *y);

/* Rows first .. last - 1 of the same product, for a caller that uses them while
 * they are still in the cache; but each field has its own diagonal, diag[m * i
 * + k], in place of A->diag. Without diag (NULL) the product has no diagonal
 * part.
 */
void csr_rows_each(int first, int last, const struct csr *A, int m,
                   const double *diag, const double *x, double *y);

#endif
