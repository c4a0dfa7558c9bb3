/* stability.h -- limits of a coupled step besides those of the particles.
 *
 * Chapter "Which treatment is stable".
 *
 * The drag on a bed that moves as a whole is 1/eps_f^2 times that on one
 * particle in it, because the fluid is frozen while the particles move:
 *
 *   dt < 2 eps_f^2 tau_p                                             (20.6)
 *
 * The fluid flows back between the particles one step after they have moved.
 * With r = rho_s/rho_f and q = eps_s/eps_f, an acceleration of the bed is
 * multiplied in each step by a root L of
 *
 *   (r + C) L^2 + q (1 + 2 C + s q C) L + (1 - s) q^2 C = 0         (20.10)
 *
 * where C is the added mass and s the share of its reaction that the fluid
 * receives in the same step.
 */
#ifndef COUPLING_STABILITY_H
#define COUPLING_STABILITY_H

#include "coupling/effect_scales.h"

/* The longest step [s] of the fluid above a packed bed of which eps_f [-] is
 * fluid, and whose particles relax within tau_p [s]. */
double stability_longest_step(double eps_f, double tau_p);

/* The longest step over tau_p [-] of a suspension with frozen drag, one update
 * a step, and semi-implicit treatment: 2 for M = 0, 1/2 for the heaviest. */
double stability_frozen_limit(double M);

/* Mass of the particles over that of the fluid in the same volume, M [-]. */
double stability_loading(double rho_s, double eps_s, double rho_f);

/* The factor [-], without its sign, by which an acceleration of a bed is
 * multiplied in a step: of a bed that is free (20.10), (20.12), or of the fluid
 * in a bed at rest (20.13). From 1 on it grows. `implicit`: the treatment of
 * the drag is semi-implicit, which charges the fluid in advance. */
double stability_amplification(const struct added_mass *added, double ratio,
                               double eps_s, int implicit);

/* The solid fraction [-] at which that is 1. */
double stability_max_solid_fraction(const struct added_mass *added,
                                    double ratio, int implicit);

#endif
