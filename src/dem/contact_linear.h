/* contact_linear.h -- spring and dashpot.
 * Chapter "Particles and contact".
 *
 *   m* delta'' + eta delta' + k delta = 0                           [LS 4.4]
 *   eta = -2 ln e sqrt(m* k) / sqrt(pi^2 + ln^2 e)
 *
 * Two spheres separate when delta is back at 0, after half a period, with the
 * fraction e of their speed. Shortly before, the force of the dashpot exceeds
 * that of the spring, and the whole force is attractive. It is not cut off,
 * because the formula for eta holds for the whole half period.
 *
 * Tangentially the mass that a sticking contact moves is (2/7) m*, since the
 * force also turns the spheres. We take k_t = (2/7) k, which gives the spring
 * xi the same period as the overlap, and eta_t for the same damping ratio: a
 * sticking contact then reverses its slip with the fraction e of its size.
 */
#ifndef DEM_CONTACT_LINEAR_H
#define DEM_CONTACT_LINEAR_H

#include <math.h>

#include "dem/contact.h"

extern const struct contact_law contact_linear;
extern const struct key contact_linear_keys[]; /* also for other laws */

/* m* = m_i m_j / (m_i + m_j) [kg]. */
static inline double contact_linear_mass(double m_i, double m_j)
{
    return m_i * m_j / (m_i + m_j);
}

/* [N] elastic part of the normal force [LS 4.4]. */
static inline double contact_linear_force(double k, double delta)
{
    return k * delta;
}

/* [kg/s] dashpot of a spring k and a mass m for the damping ratio zeta. */
static inline double contact_linear_dashpot(double zeta, double k, double m)
{
    return 2.0 * zeta * sqrt(k * m);
}

CONTACT_INLINE struct contact_response
contact_linear_respond(const struct contact_constants *k, double delta,
                       double R_star, double m_star)
{
    const double eta = contact_linear_dashpot(k->damping_n, k->normal, m_star);
    const double F = contact_linear_force(k->normal, delta);

    (void)R_star;
    return (struct contact_response){
        .elastic = F,
        .stored = 0.5 * F * delta, /* k delta^2 / 2 */
        .eta_n = eta,
        .k_t = k->tangential,
        .eta_t = k->damping_t * eta,
    };
}

/* The same of root_m = sqrt(m*). */
CONTACT_INLINE struct contact_response
contact_linear_quick(const struct contact_constants *k, double delta,
                     double R_star, double root_m)
{
    struct contact_response a = contact_linear_respond(k, delta, R_star, 1.0);

    a.eta_n *= root_m;
    a.eta_t *= root_m;
    return a;
}

/* [kg/s] eta of [LS 4.4]. */
double contact_linear_damping(double k, double e, double m_i, double m_j);

/* [s] t_c = pi / sqrt(k / m* - (eta / 2 m*)^2) [LS 4.4]. */
double contact_linear_time(double k, double e, double m_star);

#endif
