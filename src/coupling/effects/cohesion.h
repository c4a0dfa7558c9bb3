/* cohesion.h -- the attractions of dem/cohesion as effects.
 * Chapter "Materials, rolling and cohesion".
 *
 * They act within the steps of the particles, and while a bed settles:
 * therefore the particles are created with them, and the hooks of these effects
 * do nothing.
 */
#ifndef COUPLING_EFFECTS_COHESION_H
#define COUPLING_EFFECTS_COHESION_H

#include "coupling/effect.h"
#include "dem/attraction.h"

extern const struct effect cohesion_electrostatic;
extern const struct effect cohesion_van_der_waals;
extern const struct effect cohesion_capillary;

/* All of them, ended by NULL. */
extern const struct effect *const cohesion_all[];

/* The attraction with these parameters; the electrostatic one uses charges (by
 * material, borrowed). */
struct attraction cohesion_attraction(const struct effect *e,
                                      const double *parameters,
                                      const double *charge);

#endif
