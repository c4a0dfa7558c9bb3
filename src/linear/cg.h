/* cg.h -- conjugate gradients for a symmetric positive definite matrix, with a
 * preconditioner [Saad03, algorithm 9.1]. Chapter "Linear solvers".
 */
#ifndef LINEAR_CG_H
#define LINEAR_CG_H

#include "linear/preconditioned.h"

/* The report of an iterative solver.
 *
 * The caller reads it: a solver never aborts and never hides that it failed.
 */
struct solve_report {
    int iterations;
    double before, after; /* [-] 2-norm of b - A x over its scale |b|_2, at
                             entry and at return */
    int converged;        /* 1: |b - A x| is not above what was asked for */
};

struct cg_work;

struct cg_work *cg_work_create(int n);
void cg_work_free(struct cg_work *w);

/* Solves A x = b from the guess in x. Stops when |b - A x|_2 is at most
 * `absolute` or at most `reduction` times what it is for the guess, whichever
 * is larger; after max_iterations; or when a number is no longer finite or A
 * proves not to be positive. A residual below 1.5e-154, whose square is no
 * normal number, counts as 0. The report's scale is |b|_2, or 1 where b = 0. */
struct solve_report cg_solve(struct preconditioned A, const double *b,
                             double *x, double reduction /* [-] */,
                             double absolute /* unit of b */,
                             int max_iterations, struct cg_work *w);

#endif
