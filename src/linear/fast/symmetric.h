/* symmetric.h -- a symmetric matrix stored by diagonals.
 * Chapter "Linear solvers".
 *
 * On a box, owner and neighbour of a link are almost always one of a few
 * distances apart: 1, n_x, n_x n_y. Such links are stored by distance, each
 * coefficient once and without an index, and the product is vectorised:
 *
 *     (A x)_i = diag_i x_i + sum_k (u_k,i x_(i+d_k) + u_k,(i-d_k) x_(i-d_k))
 *
 * Links with any other distance are stored in a csr matrix. In an irregular
 * mesh all links are stored there, and the product is as fast as that of csr.
 *
 * A preconditioner needs few digits, and its time is spent on memory traffic,
 * so smoothing is done in single precision (measured: half the time). The
 * product for the outer iteration is in double precision, with a second copy of
 * the coefficients.
 */
#ifndef LINEAR_FAST_SYMMETRIC_H
#define LINEAR_FAST_SYMMETRIC_H

#include "linear/csr.h"

enum { SYMMETRIC_BANDS = 6 }; /* at most */

struct symmetric {
    int n, n_links;
    int n_bands, distance[SYMMETRIC_BANDS];
    int pad; /* [-] zeros before and after a vector or band, so that i - d and
                i + d need no test */
    double unit; /* [1/coefficient] the numbers in single precision are times
                    this, to be of order one */
    float *diag, *inverse;          /* the diagonal and one over it */
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

/* exact: the matrix will be multiplied in double. */
struct symmetric *symmetric_create(int n, int n_links, const int *owner,
                                   const int *neighbour, int exact);
void symmetric_free(struct symmetric *S);

/* A vector with its padding, zero; only entries 0 .. n - 1 may be written. */
float *symmetric_vector(const struct symmetric *S);
void symmetric_vector_free(const struct symmetric *S, float *x);

/* The matrix of diffusion: entry -g[l] for link l, the diagonal such that the
 * row sums are those given. Links that join a cell to itself do nothing. */
void symmetric_fill(struct symmetric *S, const double *g, const double *sums,
                    double unit);

/* With A times unit: r = b - A x, and y = alpha x + beta w + gamma D^-1
 * (b - A x). x is padded; y may be w. */
void symmetric_residual(const struct symmetric *S, const float *b,
                        const float *x, float *r);
void symmetric_relax(const struct symmetric *S, const float *b, const float *x,
                     float alpha, const float *w, float beta, float gamma,
                     float *y);

/* y = A x in double, x without padding; returns x.y. */
double symmetric_multiply(const struct symmetric *S, const double *x,
                          double *y);

#endif
