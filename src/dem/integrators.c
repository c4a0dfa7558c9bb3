/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/integrators.h"

#include <stddef.h>
#include <string.h>

const struct integrator integrators[] = {
    {"velocity-verlet", "second order where nothing damps; one evaluation",
     "LS section 4.2", 0.5, 0.5, 0},
    {"symplectic-euler", "first order, never gains energy for long",
     "LS section 4.2", 1.0, 0.0, 0},
    {"heun", "second order, damped or not; gains energy", "LS section 4.2", 0.0,
     0.0, 1},
    {NULL, NULL, NULL, 0.0, 0.0, 0}};

const struct integrator *integrators_named(const char *name)
{
    for (const struct integrator *i = integrators; i->name != NULL; i++)
        if (strcmp(i->name, name) == 0) return i;
    return NULL;
}
