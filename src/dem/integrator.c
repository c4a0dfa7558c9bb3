/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/integrator.h"

#include <math.h>

#include "base/model.h"

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

/* --- implicit drag -------------------------------------------------------- */

double implicit_drag_gain(double x)
{
    return x > 0.0 ? -expm1(-x) / x : 1.0;
}

const struct integrator *const integrators[] = {&integrators_velocity_verlet,
                                                &integrators_symplectic_euler,
                                                &integrators_heun, NULL};

MODEL_NAMED(integrator)
