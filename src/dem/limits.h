/* limits.h -- limits of the particle step.
 * Chapter "Time steps".
 *
 * Two measures of the response time of a grain: the duration of an impact, and
 * the Rayleigh time in which a surface wave travels over a sphere [LS 5.11]. A
 * step must be a small part of either.
 */
#ifndef DEM_LIMITS_H
#define DEM_LIMITS_H

#include "dem/contact.h"

/* T_R = pi r sqrt(rho / G) / (0.1631 nu + 0.8766) [s] [LS 5.11]; r [m], rho
 * [kg/m^3], G [Pa]. */
double limits_rayleigh(double r, double rho, double G, double nu);

/* Duration [s] of the impact of two equal spheres, the shortest that spheres
 * of at least d [m] and rho [kg/m^3] can have; relative speed v [m/s]. */
double limits_contact_time(const struct contact_law *law,
                           const struct material *m, double d, double rho,
                           double v);

/* The suggested step [s]: 1/25 of the contact time, and at most 1/10 of the
 * Rayleigh time where the law has one, which holds for any speed. With 25 steps
 * a contact a rebound has e to 0.013 with Hertz's law, and with the linear one
 * to 0.021 where e >= 0.7 and to 0.037 below, in the worst phase of the step
 * (test_limits); and a sphere amid twelve others, whose springs act on it
 * together, still has about 25 steps in a period of its fastest oscillation. */
double limits_step(const struct contact_law *law, const struct material *m,
                   double d, double rho, double v);

/* The longest step [s] that still resolves a contact: 1/15 of its time; and in
 * which none moves by more than d/2, so that none is past another one before
 * the two have met. (In the suggested step by 0.3 d.) In both the contact time
 * is at most 5/3 of that without damping, a limit that is reached at e = 0.015.
 */
double limits_longest_step(const struct contact_law *law,
                           const struct material *m, double d, double rho,
                           double v);

#endif
