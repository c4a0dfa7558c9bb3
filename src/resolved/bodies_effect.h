/* bodies_effect.h -- the bodies' place in the coupled loop. */
#ifndef RESOLVED_BODIES_EFFECT_H
#define RESOLVED_BODIES_EFFECT_H

#include "coupling/effect.h"
#include "resolved/solid_bodies.h"

/* Its memory is a struct solid_bodies, which it frees. The bodies move after
 * fluid and grains. */
extern const struct effect bodies_effect;

/* Its functions that serve bodies among particles as well. */
const char *bodies_effect_trouble(const void *memory);
void bodies_effect_state(void *memory, struct state *s);
void bodies_effect_free(void *memory);

#endif
