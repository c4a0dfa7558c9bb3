/* block_contacts.h -- free spheres that touch boxes and cylinders.
 * Chapter "Resolving the grains".
 *
 * All that is asked of the other body is the distance s of the sphere's centre
 * from its surface: with n the gradient of s and the overlap R - s,
 *
 *   F = (k (R - s) - eta v_n) n, not below 0     [LS 4.3, 4.4]
 *
 * and friction mu F against the slip [LS 4.8], without a spring of its own.
 */
#ifndef RESOLVED_BLOCK_CONTACTS_H
#define RESOLVED_BLOCK_CONTACTS_H

#include "resolved/solid_bodies.h"

/* Changes the velocities of spheres, and of what they touch if it is on
 * springs, by the forces of a time dt [s]. Returns the deepest overlap over the
 * diameter [-]. */
double block_contacts_act(struct solid_bodies *b, double dt);

#endif
