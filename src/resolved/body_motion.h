/* body_motion.h -- how the fluid moves the bodies.
 * Chapter "Resolving the grains".
 *
 * The fluid inside a body moves with it, and the force of the fluid outside is
 * J/dt + rho V dU/dt [EW18 2, 3]. The change of the velocity in a step, Delta U
 * = U^(n+1) - U^n, has a part by fluid and weight and one by contacts (24.15),
 *
 *   (rho_p + C_v rho) V Delta U_f = J + (rho_p - rho) V g dt
 *     + rho V Delta U_old + C_v rho V Delta U_f,old + C_c rho V Delta U_c,old
 *   (rho_p + C_c rho) V Delta U_c = contacts
 *
 * of which _old is in the step before; a spring adds -k (X - X_0) to the
 * contacts. Likewise with the moments of inertia, with C_v alone or what
 * (24.10) asks for, and a C_c of 0 for spheres. C_v rho V stands on both sides:
 * it does nothing to a steady motion, and keeps light bodies stable.
 */
#ifndef RESOLVED_BODY_MOTION_H
#define RESOLVED_BODY_MOTION_H

#include "resolved/solid_bodies.h"

/* One step of dt [s] of all bodies, with the impulses of this step, which are 0
 * again afterwards. Non-zero if one is lost. */
int body_motion_advance(struct solid_bodies *b, double dt);

/* The same in parts, among particles: the forces of a step of dt [s], a part of
 * it in n steps of `step` [s], and the spin that an angular impulse of contacts
 * [N m s] gives. */
void body_motion_set_forces(struct solid_bodies *b, double dt);
int body_motion_run(struct solid_bodies *b, int n, double step);
/* Mass that resists a spin, over the moments by mass, in the step [kg]. */
double body_motion_turning_mass(const struct solid_bodies *b, int i);
void body_motion_add_spin(struct solid_bodies *b, int i,
                          const double impulse[3]);

/* 1 if forces move body i along axis k: not where a spring holds it without a
 * way, nor between walls that it reaches. */
int body_motion_moves_along(const struct solid_bodies *b, int i, int k);

/* Adds rho_p V U - rho V U_old + C_v rho V Delta U_f + C_c rho V Delta U_c,
 * with U_old the velocity that the fluid inside has got already [N s] (24.13).
 */
void body_motion_add_momentum(const struct solid_bodies *b, double total[3]);

/* The orientation of bodies that are no spheres, and their
 * moments of inertia.
 *
 * The unit quaternion q maps the frame of the body to that of the box, and
 * dq/dt = (1/2) omega q. In the frame of the box the moments of inertia over
 * the mass are G = Q G_0 Q^T.
 */

/* The bodies are as they were given: Q is 1. */
void body_turn_begin(struct solid_bodies *b);

/* All outlines that spin, by a time dt [s]; loads their Q from b->turn. */
void body_turn_advance(struct solid_bodies *b, double dt);
void body_turn_load(struct solid_bodies *b);

/* G [m^2] of an outline: xx, xy, xz, yy, yz, zz; and G v. */
void body_turn_gyration(const struct solid_bodies *b, int i, double G[6]);
void body_turn_times(const double G[6], const double v[3], double product[3]);

#endif
