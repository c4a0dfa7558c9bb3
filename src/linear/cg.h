/* cg.h -- conjugate gradients for a symmetric positive definite matrix.
 *
 * Chapter "Linear solvers".
 */
#ifndef LINEAR_CG_H
#define LINEAR_CG_H

#include "linear/csr.h"
#include "linear/multigrid/multigrid.h"
#include "linear/report.h"

struct cg_work;

struct cg_work *cg_work_create(int n);
void cg_work_free(struct cg_work *w);

/* Solves A x = b from the guess in x, preconditioned by mg (updated from the
 * same A; A itself may then be NULL) or, if mg is NULL, by the diagonal. Stops
 * when |b - A x|_2 <= max(tolerance |b|_2, absolute), after max_iterations, or
 * when a number is no longer finite or A proves not to be positive. b = 0 gives
 * x = 0, and a residual below 1.5e-154, whose square is no normal number,
 * counts as 0. */
struct solve_report cg_solve(const struct csr *A, struct multigrid *mg,
                             const double *b, double *x,
                             double tolerance /* [-] */,
                             double absolute /* unit of b */,
                             int max_iterations, struct cg_work *w);

/* The same, but stops when the residual is the initial one times `enough` [-].
 */
struct solve_report cg_reduce(const struct csr *A, struct multigrid *mg,
                              const double *b, double *x, double enough,
                              double absolute, int max_iterations,
                              struct cg_work *w);

#endif
