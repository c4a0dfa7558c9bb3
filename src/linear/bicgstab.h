/* bicgstab.h -- BiCGStab for the three components of a momentum equation.
 *
 * Chapter "Linear solvers".
 *
 * The components are interleaved, x[3 * i + k]. They have the same off-diagonal
 * entries; each has its own diagonal, diag3[3 * i + k], which is also the
 * preconditioner (Jacobi). Each component has its own step lengths and its own
 * stopping test.
 */
#ifndef LINEAR_BICGSTAB_H
#define LINEAR_BICGSTAB_H

#include "linear/ldu.h"
#include "linear/cg.h"

struct bicgstab_work;

struct bicgstab_work *bicgstab_work_create(int n);
void bicgstab_work_free(struct bicgstab_work *w);

/* Solves A x = b from the guess in x. Stops when, for each component, |b - A
 * x|_2 <= max(tolerance |b|_2, absolute). The scale |b| is the 2-norm over all
 * three components, so that a component that is almost zero is not solved more
 * accurately than the vector needs. The report is that of the worst component;
 * a guess within the tolerance costs 0 iterations. After a breakdown the method
 * restarts from the current x, if x has changed at all. diag3 has no zeros. */
struct solve_report bicgstab_solve(const struct ldu *A, const double *diag3,
                                   const double *b3, double *x3,
                                   double tolerance /* [-] */,
                                   double absolute /* unit of b */,
                                   int max_iterations, struct bicgstab_work *w);

/* The residual b - A x of the last solution, 3 n numbers, by the recurrence of
 * the iteration. */
const double *bicgstab_residual(const struct bicgstab_work *w);

#endif
