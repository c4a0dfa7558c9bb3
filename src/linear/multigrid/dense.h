/* dense.h -- direct solution of a small symmetric system.
 * Chapter "Linear solvers".
 *
 * A = L D L^T, L with a unit diagonal. If a pivot is zero within rounding (in a
 * singular system, such as that of the pressure between walls), its unknown is
 * set to zero, because a division would only amplify rounding errors.
 */
#ifndef LINEAR_MULTIGRID_DENSE_H
#define LINEAR_MULTIGRID_DENSE_H

struct dense;

struct dense *dense_create(int n);
void dense_free(struct dense *D);

/* Returns the matrix, n columns of n numbers, of which only the lower part is
 * used. The caller fills it; dense_factor then factors it in place. */
double *dense_matrix(struct dense *D);
void dense_factor(struct dense *D);

/* x = A^-1 b; x may be b. */
void dense_solve(const struct dense *D, const double *b, double *x);

#endif
