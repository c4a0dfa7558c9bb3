/* rolling.h -- rolling friction of a contact. Chapter "Materials, rolling and
 * cohesion".
 *
 * The elastic-plastic model with a dashpot, type C of [Ai11]: a spring whose
 * angle theta grows by the relative rotation of the two, and which slips like
 * the tangential one where its moment is more than mu_r R* |F_n|:
 *
 *   M = -k_r theta - C_r w_t,   |M| <= mu_r R* |F_n|
 *   k_r = k_t R*^2,   C_r = 2 zeta_r sqrt(I_r k_r),
 *   1/I_r = 1/(I_i + m_i R_i^2) + 1/(I_j + m_j R_j^2)
 *
 * w_t is omega_i - omega_j without its part along n; it and M are the same in a
 * rotating frame of reference. Where it slips, the spring
 * is reduced until its moment is no more than the limit, as with sliding
 * friction; in [Ai11] the dashpot is dropped there. A constant moment against
 * w_t would need no theta, but a sphere would never come to rest: the moment
 * would change its sign in every step.
 */
#ifndef DEM_ROLLING_H
#define DEM_ROLLING_H

#include <math.h>

/* [-] zeta_r: the oscillation ends after a few periods; with three times this
 * ratio the dashpots of six neighbours would reverse the rotation of a sphere
 * within a step. */
static const double rolling_damping_ratio = 0.3;

/* The moment [N m] on particle i; theta is moved on by dt [s] and cut back
 * where it slips. w: omega_i - omega_j [rad/s]; limit: mu_r R* |F_n| [N m]. */
static inline void rolling_moment(double M[3], double theta[3],
                                  const double w[3], const double n[3],
                                  double k_r, double C_r, double limit,
                                  double dt)
{
    const double spin = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    const double normal = theta[0] * n[0] + theta[1] * n[1] + theta[2] * n[2];
    double size = 0.0, elastic2 = 0.0;

    for (int a = 0; a < 3; a++) {
        const double w_t = w[a] - spin * n[a];
        theta[a] += w_t * dt - normal * n[a];
        M[a] = -k_r * theta[a] - C_r * w_t;
        size += M[a] * M[a];
        elastic2 += k_r * theta[a] * k_r * theta[a];
    }
    size = sqrt(size);
    if (size <= limit) return;
    for (int a = 0; a < 3; a++) {
        M[a] *= limit / size;
        if (elastic2 > limit * limit) theta[a] = -M[a] / k_r;
    }
}

#endif
