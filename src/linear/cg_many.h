/* cg_many.h -- conjugate gradients for several fields at once.
 * Chapter "Linear solvers".
 *
 * The m fields are interleaved, x[m * i + k], and have the same matrix, so each
 * coefficient is read once for all fields. Each field has its own step lengths,
 * and the iteration ends when the last field has converged.
 *
 * Preconditioned by the given weights: z_i = r_i / weight_i. With A = V + K,
 * K without row sums (diffusion without flux out) and weight = V, a start from
 * the field u of b = V u keeps sum_i V_i x_i to rounding: all residuals and
 * directions then have the sum, or the V-weighted sum, zero.
 */
#ifndef LINEAR_CG_MANY_H
#define LINEAR_CG_MANY_H

#include "linear/csr.h"
#include "linear/cg.h"

enum { CG_MANY_FIELDS = 16 }; /* at most */

struct cg_many_work;

struct cg_many_work *cg_many_work_create(int n, int m);
void cg_many_work_free(struct cg_many_work *w);

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

#endif
