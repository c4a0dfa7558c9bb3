/* solvers.h -- iterative solvers of sparse systems, and what makes them fast.
 * Chapter "Linear solvers".
 */
#ifndef LINEAR_SOLVERS_H
#define LINEAR_SOLVERS_H

#include "linear/matrix.h"

/* --- preconditioned ------------------------------------------------------- */

/* A symmetric matrix and an approximation of its inverse.
 *
 * The matrix is one of diffusion: the entry -g[l] for each link l, and a
 * diagonal such that the row sums are those given. Conjugate gradients need
 * two operations of it: the product y = A x, and M r with a symmetric positive
 * definite M close to A^-1, the preconditioner. A kind of preconditioner is
 * one descriptor, which also decides how the matrix is stored. The plain kind
 * is that of Jacobi, M = D^-1 with the diagonal D of the matrix, stored by
 * rows; the folder multigrid/ has a better one. */

/* `matrix` is what create returns, to be freed by owner_free. */
struct preconditioned_kind {
    const char *name;
    /* The matrix of n unknowns and of these links. strength [m] is the area of
     * a link's face over its length, link [m] its vector, 3 each, V [m^3] the
     * volume of each cell; all arrays are borrowed during the call only. */
    void *(*create)(int n, int n_links, const int *owner, const int *neighbour,
                    const double *strength, const double *link,
                    const double *V);
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

/* What the flow uses, and the plain kind, whose matrix is a struct csr
 * (matrix.h). */
extern const struct preconditioned_kind multigrid_preconditioned;
extern const struct preconditioned_kind preconditioned_jacobi;

/* Creates a matrix with multigrid; the arguments are those of `create`. */
struct preconditioned
preconditioned_create(int n, int n_links, const int *owner,
                      const int *neighbour, const double *strength,
                      const double *link, const double *V);

/* Sets its coefficients. */
void preconditioned_set(struct preconditioned A, const double *g,
                        const double *sums);

/* --- cg ------------------------------------------------------------------- */

/* Conjugate gradients for a symmetric positive definite matrix, with a
 * preconditioner [Saad03, algorithm 9.1]. */

/* The report of an iterative solver.
 *
 * The caller reads it: a solver never aborts and never hides that it failed. */
struct solve_report {
    int iterations;
    double before, after; /* [-] 2-norm of b - A x over its scale |b|_2, at
                             entry and at return */
    int converged;        /* 1: |b - A x| is not above what was asked for */
};

struct cg_work;

struct cg_work *cg_work_create(int n);
/* The same in three vectors of n numbers that nothing else uses meanwhile; the
 * third may be the right-hand side, which is lost. */
struct cg_work *cg_work_lent(int n, double *const space[3]);

/* Solves A x = b from the guess in x. Stops when |b - A x|_2 is at most
 * `absolute` or at most `reduction` times what it is for the guess, whichever
 * is larger; after max_iterations; or when a number is no longer finite or A
 * proves not to be positive. A residual below 1.5e-154, whose square is no
 * normal number, counts as 0. The report's scale is |b|_2, or 1 where b = 0. */
struct solve_report cg_solve(struct preconditioned A, const double *b,
                             double *x, double reduction /* [-] */,
                             double absolute /* unit of b */,
                             int max_iterations, struct cg_work *w);

/* --- cg many -------------------------------------------------------------- */

/* Conjugate gradients for several fields at once.
 *
 * The m fields are interleaved, x[m * i + k], and have the same matrix, so
 * each coefficient is read once for all fields. Each field has its own step
 * lengths, and the iteration ends when the last field has converged.
 *
 * Preconditioned by the given weights: z_i = r_i / weight_i. With A = V + K, K
 * without row sums (diffusion without flux out) and weight = V, a start from
 * the field u of b = V u keeps sum_i V_i x_i to rounding: all residuals and
 * directions then have the sum, or the V-weighted sum, zero. */

enum { CG_MANY_FIELDS = 16 }; /* at most */

struct cg_many_work;

struct cg_many_work *cg_many_work_create(int n, int m);

/* dot[k] = sum_i x[m * i + k] y[m * i + k] for m fields side by side. */
void cg_many_dot(int n, int m, const double *x, const double *y, double *dot);

/* Solves A x = b from the guess in x for the m fields of the work space, until
 * each field has |r| <= max(tolerance |b|, absolute): relative to its own b, as
 * bicgstab_solve, and not to the first residual, as cg_solve. The report is
 * that of the field that is worst relative to its |b|. weight = NULL: the
 * diagonal of A. */
struct solve_report cg_many_solve(const struct csr *A, const double *weight,
                                  const double *b, double *x,
                                  double tolerance /* [-] */,
                                  double absolute /* unit of b */,
                                  int max_iterations, struct cg_many_work *w);

/* --- bicgstab ------------------------------------------------------------- */

/* BiCGStab for the three components of a momentum equation.
 *
 * The components are interleaved, x[3 * i + k]. They have the same
 * off-diagonal entries; each has its own diagonal, diag[3 * i + k], or all have
 * diag[i], as A says; it is also the preconditioner (Jacobi). Each component
 * has its own step lengths and its own stopping test. */

struct bicgstab_work;

/* In five vectors of 3 n numbers that nothing else uses during a solution; the
 * first is then the residual. */
struct bicgstab_work *bicgstab_work_lent(int n, double *const space[5]);

/* Solves A x = b from the guess in x. Stops when, for each component, |b - A
 * x|_2 <= max(tolerance |b|_2, absolute). The scale |b| is the 2-norm over all
 * three components, so that a component that is almost zero is not solved more
 * accurately than the vector needs. The report is that of the worst component;
 * a guess within the tolerance costs 0 iterations. After a breakdown the method
 * restarts from the current x, if x has changed at all. diag has no zeros. */
struct solve_report bicgstab_solve(const struct ldu *A, const double *diag,
                                   const double *b3, double *x3,
                                   double tolerance /* [-] */,
                                   double absolute /* unit of b */,
                                   int max_iterations, struct bicgstab_work *w);

/* The residual b - A x of the last solution, 3 n numbers, by the recurrence of
 * the iteration. */
const double *bicgstab_residual(const struct bicgstab_work *w);

#endif
