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
 * it does nothing to a steady motion, and keeps light bodies stable. What a
 * spin changes without a torque counts in none of them (base/rotation.h).
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
void body_motion_add_momentum(const void *bodies, double total[3]);

/* The orientation of bodies that are no spheres, and their moments of inertia.
 *
 * The unit quaternion q maps the frame of the body to that of the box, and
 * dq/dt = (1/2) omega q. In the frame of the box the moments of inertia over
 * the mass are G = Q G_0 Q^T. */

/* All outlines that spin, by a time dt [s]; loads their Q from b->turn. */
void body_turn_advance(struct solid_bodies *b, double dt);
void body_turn_load(struct solid_bodies *b);

/* G [m^2] of an outline: xx, xy, xz, yy, yz, zz; and G v. */
void body_turn_gyration(const struct solid_bodies *b, int i, double G[6]);
void body_turn_times(const double G[6], const double v[3], double product[3]);

/* --- squeeze film --------------------------------------------------------- */

/* The fluid that is squeezed out of gaps narrower than a cell.
 *
 * Between two surfaces at the distance z, 0 < z < reach, that part at the
 * speed g (negative: approach),
 *
 *   F = -6 pi mu R*^2 (1/max(z, z_min) - 1/reach) g,  R* = R_1 R_2/(R_1 + R_2)
 *
 * [Cox67], at a wall R* = R. The second term takes away what the mesh
 * resolves, so that the force begins at 0 [BVM17]. There it begins at two
 * cells; with friction by distance the mesh has nine tenths of the force at a
 * gap of one cell, and what it has grows no more below three quarters. z_min
 * is the roughness of the surfaces, at which they touch. */

/* reach over the width of a cell [-]. */
extern const double squeeze_film_cells;

/* F / -g [kg/s]. */
double squeeze_film_coefficient(double mu, double R_star, double z,
                                double z_min, double reach);

/* The speed [m/s] of parting after dt [s] of two bodies of the reduced mass m
 * [kg] that part at g and are z [m] apart. */
double squeeze_film_velocity(const struct squeeze_film *l, double R_star,
                             double m, double z, double g, double dt);

/* Changes the velocities of all bodies by the forces of a time dt [s]. */
void squeeze_film_act(struct solid_bodies *b, double dt);

/* --- body exit ------------------------------------------------------------ */

/* Bodies that leave the box through an outlet.
 *
 * An outlet is no wall to a body. What acts on the part of it that is outside
 * is not known: so, while it passes, it goes on with the velocity and spin
 * that it came with. Once it is wholly outside it has left: it is at rest, and
 * touches nothing. One that only turns out of it is moved by what is inside. */

struct body_exit {
    int open[6];         /* [-] sides 2 k, 2 k + 1: 1 for an outlet */
    double lo[3], hi[3]; /* [m] of the fluid */
    double way;          /* [m] from an outlet to where bodies end */
    int *gone, n_gone;   /* [-] 1: on its way out, 2: it has left; how many */
};

/* NULL if there is no outlet, or all bodies are held; then also nothing of the
 * contacts' box changes, which else reaches beyond the outlets. */
struct body_exit *body_exit_create(struct solid_bodies *b,
                                   const struct fluid *fl);
void body_exit_state(struct solid_bodies *b, struct state *s);

/* Takes out those that are wholly outside. */
void body_exit_look(struct solid_bodies *b);

/* 1 if the face of the box with the area S is an outlet; e may be NULL. */
int body_exit_is_open(const struct body_exit *e, const double S[3]);

#endif
