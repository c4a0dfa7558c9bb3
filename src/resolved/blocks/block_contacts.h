/* block_contacts.h -- contacts of bodies that are not all spheres.
 * Chapter "Resolving the grains".
 *
 * A ball (body_gaps.h) of the radius R whose centre is at the distance s < R
 * from the surface of another body: with n the gradient of s and the overlap R
 * - s,
 *
 *   F = (k (R - s) - eta v_n) n, not below 0     [LS 4.3, 4.4]
 *
 * and friction mu F against the slip [LS 4.8], without a spring of its own.
 */
#ifndef RESOLVED_BLOCKS_BLOCK_CONTACTS_H
#define RESOLVED_BLOCKS_BLOCK_CONTACTS_H

#include "resolved/solid_bodies.h"

extern const struct body_contacts block_contacts;

/* Changes the velocities of what touches and can move, by the forces of a time
 * dt [s]. Returns the deepest overlap over the diameter of a ball [-]. */
double block_contacts_act(struct solid_bodies *b, double dt);

#endif
