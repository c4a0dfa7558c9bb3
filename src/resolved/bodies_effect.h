/* bodies_effect.h -- the bodies' place in the coupled loop. */
#ifndef RESOLVED_BODIES_EFFECT_H
#define RESOLVED_BODIES_EFFECT_H

#include "coupling/effect.h"
#include "resolved/solid_bodies.h"

/* Its memory is a struct solid_bodies, which it frees. The bodies move after
 * fluid and grains. */
extern const struct effect bodies_effect;

/* The same where there are particles with which they move. */
extern const struct effect among_effect;

#endif
