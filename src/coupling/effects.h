/* effects.h -- the list of all effects.  Chapter "The coupled loop". */
#ifndef COUPLING_EFFECTS_H
#define COUPLING_EFFECTS_H

#include "coupling/effect.h"

extern const struct effect energy_budget_effect;
extern const struct effect gravity_effect;
extern const struct effect pressure_gradient_effect;
extern const struct effect stochastic_drag_effect;
extern const struct effect virtual_mass_effect;
extern const struct effect viscous_stress_effect;
extern const struct effect time_average_effect;

/* All of them, ended by NULL, and the one of that name or NULL. */
extern const struct effect *const effects[];
const struct effect *effects_named(const char *name);

#endif
