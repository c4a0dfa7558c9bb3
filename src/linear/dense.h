/* dense.h -- direct solution of a small symmetric system.  Chapter 7.
 *
 * A = L D L^T, L with a unit diagonal. A pivot that vanishes within rounding
 * (a system that is singular, as that of pressure between walls) leaves its
 * unknown at zero instead of dividing by noise.
 */
#ifndef DENSE_H
#define DENSE_H

struct dense;

struct dense *dense_create(int n);
void dense_free(struct dense *D);

/* The matrix itself, n columns of n, of which the lower part counts. To be
 * filled, then factored in place. */
double *dense_matrix(struct dense *D);
void dense_factor(struct dense *D);

/* x = A^-1 b; x may be b. */
void dense_solve(const struct dense *D, const double *b, double *x);

#endif
