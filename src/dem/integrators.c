/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/integrators.h"

#include <stddef.h>
#include <string.h>

const struct integrator integrators_velocity_verlet = {
    .name = "velocity-verlet",
    .what = "second order without damping; forces computed once a step",
    .equations = "LS section 4.2",
    .function = "bodies_advance",
    .first = 0.5,
    .last = 0.5,
};

const struct integrator integrators_symplectic_euler = {
    .name = "symplectic-euler",
    .what = "first order; its energy error stays bounded",
    .equations = "LS section 4.2",
    .function = "bodies_advance",
    .first = 1.0,
};

const struct integrator *integrators_named(const char *name)
{
    for (int i = 0; integrators[i] != NULL; i++)
        if (strcmp(integrators[i]->name, name) == 0) return integrators[i];
    return NULL;
}
