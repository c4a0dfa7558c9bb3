/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects.h"

#include "coupling/effects/cohesion.h"

#include <string.h>

const struct effect *const effects_all[] = {
    &gravity_effect,         &pressure_gradient_effect,
    &viscous_stress_effect,  &virtual_mass_effect,
    &time_average_effect,    &energy_budget_effect,
    &cohesion_electrostatic, &cohesion_van_der_waals,
    &cohesion_capillary,     NULL};

const struct effect *effects_named(const char *name)
{
    for (const struct effect *const *e = effects_all; *e != NULL; e++)
        if (strcmp((*e)->name, name) == 0) return *e;
    return NULL;
}
