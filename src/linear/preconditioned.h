/* preconditioned.h -- a symmetric matrix and an approximation of its inverse.
 * Chapter "Linear solvers".
 *
 * The matrix is one of diffusion: the entry -g[l] for each link l, and a
 * diagonal such that the row sums are those given. Conjugate gradients need two
 * operations of it: the product y = A x, and M r with a symmetric positive
 * definite M close to A^-1, the preconditioner. A kind of preconditioner is one
 * descriptor, which also decides how the matrix is stored. The plain kind is
 * that of Jacobi, M = D^-1 with the diagonal D of the matrix, stored by rows;
 * the folder multigrid/ has a better one.
 */
#ifndef LINEAR_PRECONDITIONED_H
#define LINEAR_PRECONDITIONED_H

/* `matrix` is what create returns. */
struct preconditioned_kind {
    const char *name;
    /* The matrix of n unknowns and of these links. strength [m] is the area of
     * a link's face over its length, link [m] its vector, 3 each, V [m^3] the
     * volume of each cell; all arrays are borrowed during the call only. */
    void *(*create)(int n, int n_links, const int *owner, const int *neighbour,
                    const double *strength, const double *link,
                    const double *V);
    void (*free)(void *matrix);
    /* Sets the coefficients: g of each link, and the row sums; both >= 0. */
    void (*set)(void *matrix, const double *g, const double *sums);
    /* y = A x; returns x.y. */
    double (*multiply)(const void *matrix, const double *x, double *y);
    /* Computes M r, which stays in the matrix, and returns r.M r; rr is r.r.
     * Then p = M r + beta p. */
    double (*apply)(void *matrix, const double *r, double rr);
    void (*direction)(const void *matrix, const double *r, double beta,
                      double *p);
};

struct preconditioned {
    const struct preconditioned_kind *kind;
    void *matrix;
};

/* What the flow uses, and the plain kind, whose matrix is a struct csr (csr.h).
 */
extern const struct preconditioned_kind multigrid_preconditioned;
extern const struct preconditioned_kind preconditioned_jacobi;

/* Creates a matrix with multigrid; the arguments are those of `create`. */
struct preconditioned
preconditioned_create(int n, int n_links, const int *owner,
                      const int *neighbour, const double *strength,
                      const double *link, const double *V);
void preconditioned_free(struct preconditioned A);

/* Sets its coefficients. */
void preconditioned_set(struct preconditioned A, const double *g,
                        const double *sums);

#endif
