/* chebyshev.h -- diffusion over a time T without a time step.
 * Chapter "Averaging".
 *
 * With L = V^-1 K the solution of du/dt = -L u is u(T) = exp(-T L) u(0). All
 * eigenvalues of L lie in [0, lambda], so the exponential is a short series of
 * Chebyshev polynomials of L, with z = lambda T:
 *
 *     u(T) = sum_k c_k y_k,  c_k = (2 - [k = 0]) exp(-z/2) I_k(z/2)
 *     y_0 = u,  y_1 = u - (2/lambda) L u,
 *     y_(k+1) = 2 (y_k - (2/lambda) L y_k) - y_(k-1)
 *
 * The series costs about sqrt(z) matrix products and no solution of a system,
 * and it is self-adjoint in the inner product weighted by V. c_0 is shifted so
 * that the c_k sum to one: then sum_i V_i u_i is kept to rounding. An
 * undershoot is at most the tail times the largest |u|.
 */
#ifndef LINEAR_CHEBYSHEV_H
#define LINEAR_CHEBYSHEV_H

#include "linear/matrix.h"

struct chebyshev {
    const struct csr *K; /* borrowed */
    double *factor;      /* [1/m] 2 / (lambda V) of each row */
    int products;
    double *c;          /* [-] products + 1 coefficients */
    int m;              /* fields there is room for */
    double *y[2], *sum; /* two terms y_k, and the series so far */
};

/* The series of exp(-T L) for up to m fields. K is symmetric, its entries off
 * the diagonal are <= 0 [m] and its rows sum to zero (no flux leaves); K and V
 * are borrowed. V must not change; the coefficients of K may become smaller
 * while its rows still sum to zero, because the series holds for all L whose
 * eigenvalues do not exceed the present lambda. The series is cut where the sum
 * of the remaining terms is below tail. */
struct chebyshev *chebyshev_create(const struct csr *K,
                                   const double *V /* [m^3] */,
                                   double T /* [m^2] */, double tail /* [-] */,
                                   int m);

/* u becomes exp(-T L) u, for m fields side by side, u[m * i + k]; m at most
 * that of create. */
void chebyshev_apply(struct chebyshev *s, int m, double *u);

/* Products with K that one application costs. */
int chebyshev_products(const struct chebyshev *s);

#endif
