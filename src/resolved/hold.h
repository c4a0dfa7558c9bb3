/* hold.h -- friction that holds the fluid in the bodies.
 * Chapter "Resolving the grains".
 */
#ifndef RESOLVED_HOLD_H
#define RESOLVED_HOLD_H

#include "resolved/solid_bodies.h"

extern const struct body_method hold_method;

/* Adds hold (u_b - u) to the momentum equation, implicit in u, and takes the
 * impulse of each step for the bodies. */
void hold_fluid(struct solid_bodies *b);

#endif
