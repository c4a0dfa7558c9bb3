/* basset.h -- Basset's history force.  Chapter "Further forces".
 *
 *   F = (3/2) d^2 sqrt(pi rho mu) [ int_0^t w'(s)/sqrt(t - s) ds + w(0)/sqrt(t)
 * ] [LS 5.4]
 *
 * with w = u - v at the particle and w' along its path. The kernel is a sum of
 * exponentials,
 *
 *   1/sqrt(t) = sum_k c_k exp(-s_k t),   dt <= t <= 1e6 dt,
 *
 * the trapezium rule for (1/sqrt(pi)) int exp(y/2 - t e^y) dy with spacing
 * pi^2/ln(2/tol). Each term needs one vector a particle, whose past decays by a
 * factor a step: neither memory nor work grow with time. The last step, in
 * which the kernel is singular, and the one before are integrated exactly for a
 * w that is linear in each step.
 */
#ifndef COUPLING_EFFECTS_BASSET_H
#define COUPLING_EFFECTS_BASSET_H

enum { BASSET_TERMS = 64 }; /* at most */

struct basset_kernel {
    int n;                  /* [-] terms */
    double c[BASSET_TERMS]; /* [1/sqrt(s)] */
    double s[BASSET_TERMS]; /* [1/s] */
};

/* The terms for steps of dt [s] and a largest relative error `tolerance` [-],
 * from 2e-5 (51 terms) to 0.1 (10). */
struct basset_kernel basset_kernel_create(double dt, double tolerance);

/* The sum at time t [s]: about 1/sqrt(t). */
double basset_kernel_value(const struct basset_kernel *k, double t);

/* (3/2) d^2 sqrt(pi rho mu) [kg/sqrt(s)]. */
double basset_coefficient(double rho, double mu, double d);

/* The force [N] after a time t [s] of the constant rate dw/dt [m/s^2], from
 * w = 0 [LS 5.4]. */
double basset_force(double rho, double mu, double d, double t, double rate);

#endif
