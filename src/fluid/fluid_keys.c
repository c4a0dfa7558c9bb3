/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fluid_keys.c -- the keys of the group `fluid`, and the members of struct
 * fluid_options that they fill. */
#include "fluid/fluid.h"

#define AT(member) .at = KEY_AT(fluid_options, member)

const struct key fluid_keys[] = {
    {"fluid", KEY_GROUP, "", "", "", "the fluid; left out: particles alone",
     "XS11 2.7, 2.8", "", .mark = KEY_AFTER_BED, .divided = KEY_DIVIDED_ALL},
    {"fluid.density", KEY_REAL, "kg/m^3", "> 0", NULL,
     "density of the fluid, rho_f", "XS11 2.8", "", AT(rho)},
    {"fluid.viscosity", KEY_REAL, "Pa s", ">= 0", NULL, "dynamic viscosity, mu",
     "XS11 2.8", "", AT(mu)},
    {"fluid.step", KEY_REAL, "s", "> 0", NULL,
     "time step of the fluid and of the coupling", "XS11 Algorithm 3.1", "",
     AT(dt)},
    {"fluid.time", KEY_NAME, "", "", "euler",
     "time scheme: implicit Euler or second-order implicit", "XS11, SX15", "",
     AT(time), .models = time_schemes},
    {"fluid.convection", KEY_NAME, "", "", "upwind", "convection scheme",
     "XS11 2.8", "", AT(convection), .models = convection_schemes},
    {"fluid.continuity", KEY_NAME, "", "", "mixture",
     "form of the mass balance", "XS11 2.3, 2.7", "", AT(continuity),
     .choices = fluid_continuity_forms},
    {"fluid.correctors", KEY_INT, "-", ">= 1, <= 20", "2",
     "pressure corrections in a step (PISO), at least", "XS11 Algorithm 3.1",
     "", AT(correctors)},
    {"fluid.piso_tolerance", KEY_REAL, "-", ">= 0", "1e-3",
     "further corrections until the relative splitting error of the momentum "
     "is below this, and small beside the inertia; 0: none",
     "", "", AT(piso_tolerance)},
    {"fluid.outer_correctors", KEY_INT, "-", ">= 0, <= 20", "0",
     "outer iterations: how often a step is repeated with its new velocity", "",
     "", AT(outer_correctors)},
    {"fluid.u_tolerance", KEY_REAL, "-", ">= 0, < 1", "0.0",
     "residual of the predicted velocity; 0: fluid.tolerance", "", "",
     AT(u_tolerance)},
    {"fluid.p_relative_tolerance", KEY_REAL, "-", ">= 0, < 1", "0.0",
     "relative residual at which all corrections but the last stop", "", "",
     AT(p_relative_tolerance)},
    {"fluid.cfl", KEY_REAL, "-", "> 0", "",
     "largest Courant number; where fluid.step has a larger one it is divided",
     "LS 5.9, 5.10", "", AT(cfl)},
    {"fluid.mean_gradient", KEY_VECTOR, "Pa/m", "", "",
     "mean gradient of the pressure in periodic directions", "", "",
     AT(mean_gradient), .given = KEY_AT(fluid_options, has_mean_gradient)},
    {"fluid.mean_flow", KEY_VECTOR, "m/s", "", "",
     "mean superficial velocity that is kept in periodic directions", "", "",
     AT(mean_flow), .given = KEY_AT(fluid_options, has_mean_flow)},
    {"fluid.tolerance", KEY_REAL, "-", ">= 1e-15, < 1", "1e-8",
     "relative residual of the linear solvers", "", "", AT(tolerance)},
    {"fluid.<patch>", KEY_PATCH, "", "", "",
     "a side of the box: left right (x), bottom top (y), back front (z), or "
     "two at once: sides, bottom_top, front_back; or a patch of the mesh",
     "XS11 2.8", ""},
    KEY_END};
