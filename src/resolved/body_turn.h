/* body_turn.h -- the orientation of bodies that are no spheres, and their
 * moments of inertia. Chapter "Resolving the grains".
 *
 * The unit quaternion q maps the frame of the body to that of the box, and
 * dq/dt = (1/2) omega q. In the frame of the box the moments of inertia over
 * the mass are G = Q G_0 Q^T.
 */
#ifndef RESOLVED_BODY_TURN_H
#define RESOLVED_BODY_TURN_H

#include "resolved/solid_bodies.h"

/* The bodies are as they were given: Q is 1. */
void body_turn_begin(struct solid_bodies *b);

/* All outlines that spin, by a time dt [s]; loads their Q from b->turn. */
void body_turn_advance(struct solid_bodies *b, double dt);
void body_turn_load(struct solid_bodies *b);

/* G [m^2] of an outline: xx, xy, xz, yy, yz, zz; and G v. */
void body_turn_gyration(const struct solid_bodies *b, int i, double G[6]);
void body_turn_times(const double G[6], const double v[3], double product[3]);

#endif
