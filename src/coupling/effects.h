/* effects.h -- the list of all effects.  Chapter "The coupled loop". */
#ifndef COUPLING_EFFECTS_H
#define COUPLING_EFFECTS_H

#include "coupling/effect.h"

extern const struct effect energy_budget_effect;
extern const struct effect gravity_effect;
extern const struct effect pressure_gradient_effect;
extern const struct effect virtual_mass_effect;
extern const struct effect viscous_stress_effect;
extern const struct effect time_average_effect;

/* All of them, ended by NULL, and the one of that name or NULL. */
extern const struct effect *const effects[];
const struct effect *effects_named(const char *name);

/* Adds an active effect to the simulation, which frees its memory. */
void effects_add(struct simulation *sim, const struct effect *e, void *memory);

/* The memory of that effect; NULL if it is not active. */
void *effects_memory(const struct simulation *sim, const struct effect *e);

#endif
