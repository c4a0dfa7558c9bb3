/* among_effect.h -- the bodies' place in the coupled loop, where there are
 * particles with which they move. Chapter "Resolving the grains". */
#ifndef RESOLVED_AMONG_AMONG_EFFECT_H
#define RESOLVED_AMONG_AMONG_EFFECT_H

#include "coupling/effect.h"

/* Its memory is a struct solid_bodies, which it frees. */
extern const struct effect among_effect;

#endif
