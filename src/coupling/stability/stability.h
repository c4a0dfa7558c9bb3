/* stability.h -- limits of a coupled step besides those of the particles.
 *
 * Chapter "Which treatment is stable".
 *
 * The drag on a bed that moves as a whole is 1/eps_f^2 times that on one
 * particle in it, because the fluid is frozen while the particles move; and the
 * reaction of the pressure force on the particles acts on the fluid one step
 * later:
 *
 *   dt < 2 eps_f^2 tau_p                                             (20.6)
 *   lambda = (1 + C) / (rho_s / rho_f + C) * eps_s / eps_f < 1       (20.9)
 */
#ifndef COUPLING_STABILITY_STABILITY_H
#define COUPLING_STABILITY_STABILITY_H

/* The longest step [s] of the fluid above a packed bed of which eps_f [-] is
 * fluid, and whose particles relax within tau_p [s]. */
double stability_longest_step(double eps_f, double tau_p);

/* The longest step over tau_p [-] of a suspension with frozen drag, one update
 * a step, and semi-implicit treatment: 2 for M = 0, 1/2 for the heaviest. */
double stability_frozen_limit(double M);

/* Mass of the particles over that of the fluid in the same volume, M [-]. */
double stability_loading(double rho_s, double eps_s, double rho_f);

/* Amplification of an oscillation of the pressure in one step, with its sign
 * reversed [-]; C is the coefficient of virtual mass, 0 without it. From 1 on
 * the oscillation grows. */
double stability_amplification(double C, double rho_s, double eps_s,
                               double rho_f);

/* The solid fraction [-] at which that is 1. */
double stability_max_solid_fraction(double C, double rho_s, double rho_f);

#endif
