/* contact_hertz.h -- elastic spheres after Hertz and Mindlin.
 * Chapter "Particles and contact".
 *
 *   F_n = (4/3) E* sqrt(R*) delta^(3/2)                        [LS 4.7, 4.9]
 *   k_t = 8 G* sqrt(R*) sqrt(delta)                            [LS 4.10]
 *   eta = 2 sqrt(5/6) zeta sqrt(S m*)       [LS 4.12, with e instead of 0]
 *
 * with S_n = 2 E* sqrt(R* delta) along n, S_t = k_t across it, and zeta of e
 * (contact.h); sqrt(5/6) makes e exact. The contact ends at delta = 0.
 */
#ifndef DEM_CONTACT_HERTZ_H
#define DEM_CONTACT_HERTZ_H

#include <math.h>

#include "base/root.h"
#include "dem/contact.h"

extern const struct contact_law contact_hertz;
extern const struct key contact_hertz_keys[]; /* also for other laws */

/* E* [Pa]: 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j [LS 4.9]. */
double contact_hertz_modulus(double E_i, double nu_i, double E_j, double nu_j);

/* G* [Pa]: 1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j, G = E/(2 (1 + nu)).
 * [LS 4.10] prints 1 - nu^2 for 2 - nu here; this is Mindlin's. */
double contact_hertz_shear(double E_i, double nu_i, double E_j, double nu_j);
/* R* = R_i R_j / (R_i + R_j) [m]. */
double contact_hertz_radius(double R_i, double R_j);
/* [N/m^1.5] k_n = (4/3) E* sqrt(R*) [LS 4.9]. */
double contact_hertz_stiffness(double E_star, double R_star);
/* [s] of an elastic head-on impact at v [m/s]: 2.9432 delta_max / v. */
double contact_hertz_time(double E_star, double R_star, double m_star,
                          double v);

/* [N] k_n delta^(3/2) [LS 4.7]. */
static inline double contact_hertz_force(double E_star, double R_star,
                                         double delta)
{
    return 4.0 / 3.0 * E_star * sqrt(R_star * delta) * delta;
}

/* [N/m] k_t = 8 G* sqrt(R*) sqrt(delta) [LS 4.10]. */
static inline double contact_hertz_tangential(double G_star, double R_star,
                                              double delta)
{
    return 8.0 * G_star * sqrt(R_star * delta);
}

/* [N/m] S_n = dF_n/d delta = 2 E* sqrt(R* delta). */
static inline double contact_hertz_slope(double E_star, double R_star,
                                         double delta)
{
    return 2.0 * E_star * sqrt(R_star * delta);
}

/* [kg/s] 2 sqrt(5/6) zeta sqrt(S m*). */
static inline double contact_hertz_damping(double zeta, double S, double m_star)
{
    const double root = 0.91287092917527685576; /* sqrt(5/6) */
    return 2.0 * root * zeta * sqrt(S * m_star);
}

CONTACT_INLINE struct contact_response
contact_hertz_respond(const struct contact_constants *k, double delta,
                      double R_star, double m_star)
{
    const double S_n = contact_hertz_slope(k->normal, R_star, delta);
    const double eta = contact_hertz_damping(k->damping_n, S_n, m_star);
    const double F = contact_hertz_force(k->normal, R_star, delta);

    return (struct contact_response){
        .elastic = F,
        .stored = 0.4 * F * delta, /* (2/5) k_n delta^(5/2) */
        .eta_n = eta,
        .k_t = contact_hertz_tangential(k->tangential, R_star, delta),
        .eta_t = k->damping_t * eta,
    };
}

/* The same for vector loops, from root_m = sqrt(m*) and one y = (R*
 * delta)^(-1/4): delta is a difference of lengths near d, not below 1e-16 d, so
 * that even for a d of 1e-10 m R* delta is in the range of root.h. */
CONTACT_INLINE struct contact_response
contact_hertz_quick(const struct contact_constants *k, double delta,
                    double R_star, double root_m)
{
    const double a2 = R_star * delta, y = root_inverse_fourth(a2);
    const double a_half = a2 * y * y * y, a = a_half * a_half;
    const double eta =
        contact_hertz_damping(k->damping_n, 2.0 * k->normal, 1.0);
    const double F = 4.0 / 3.0 * k->normal * a * delta;

    return (struct contact_response){
        .elastic = F,
        .stored = 0.4 * F * delta,
        .eta_n = eta * a_half * root_m,
        .k_t = 8.0 * k->tangential * a,
        .eta_t = k->damping_t * eta * a_half * root_m,
    };
}

#endif
