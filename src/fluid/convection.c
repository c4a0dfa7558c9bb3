/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/schemes.h"

#include "base/model.h"
#include "fluid/fluid.h"

/* The weights of upwind, which schemes with a deferred part use as well. */
static void convection_upwind_weights(const struct convection_faces *faces,
                                      double *weight)
{
    for (int f = 0; f < faces->n; f++)
        weight[f] = faces->phi[f] >= 0.0 ? 1.0 : 0.0;
}

const struct convection_scheme convection_upwind = {
    .name = "upwind",
    .what = "first order, bounded at any step",
    .equations = "XS11",
    .function = "convection_upwind_weights",
    .owner_weights = convection_upwind_weights,
    .damps = 1,
    .order = 1.0,
    .error = 0.5,
    .share = 1.0,
    .least = {1.0, 1.0},
    .time = 1.0,
};

static void weights_linear(const struct convection_faces *faces, double *weight)
{
    for (int f = 0; f < faces->n; f++)
        weight[f] = faces->w[f];
}

const struct convection_scheme convection_linear = {
    .name = "linear",
    .what = "second order (central), may overshoot",
    .equations = "XS11",
    .function = "weights_linear",
    .owner_weights = weights_linear,
    .order = 2.0,
    .error = 1.0 / 6.0,
    .least = {1.8, 1.2},
    .time = 1.0,
};

static void weights_blended(const struct convection_faces *faces,
                            double *weight)
{
    const double b = faces->blend;

    for (int f = 0; f < faces->n; f++)
        weight[f] =
            b * faces->w[f] + (1.0 - b) * (faces->phi[f] >= 0.0 ? 1.0 : 0.0);
}

static const struct key blend_keys[] = {
    {"fluid.blend", KEY_REAL, "-", ">= 0, <= 1", "0.5",
     "share of linear in the scheme blended", "XS11", "",
     KEY_AT(fluid_options, blend)},
    KEY_END};

const struct convection_scheme convection_blended = {
    .name = "blended",
    .what = "fluid.blend of linear, the rest upwind",
    .equations = "",
    .function = "weights_blended",
    .keys = {blend_keys},
    .owner_weights = weights_blended,
    .order = 1.0,
    .error = 0.25,
    .share = 0.5,
    .least = {1.0, 1.0},
    .time = 1.0, /* of half of each */
};

/* Schemes of convection with the gradient of the cell C from
 * which the fluid comes: upwind in the matrix, the rest deferred. */

/* Linear extrapolation from C to the face with the gradient in C. */
static double beyond_second_upwind(double step, double rise, double reach)
{
    (void)step;
    return reach * rise;
}

const struct convection_scheme convection_second_upwind = {
    .name = "second-upwind",
    .what = "second order, looks upstream only; may overshoot",
    .equations = "SX15",
    .function = "beyond_second_upwind",
    .keys = {velocity_gradient_keys},
    .owner_weights = convection_upwind_weights,
    .deferred = beyond_second_upwind,
    .order = 2.0,
    .error = 1.0 / 3.0,
    .least = {1.0, 1.0},
    .time = 1.4,
};

/* The gradient in C and that of the link limit each other [VanLeer74]: with r =
 * (u_C - u_B) / (u_D - u_C) relative to C, B being as far upstream as D is
 * downstream, psi = (r + |r|) / (1 + r) of the linear step is taken. */
static double beyond_van_leer(double step, double rise, double reach)
{
    const double back = 2.0 * rise - step; /* u_C - u_B */

    if (back * step <= 0.0) return 0.0; /* C is an extremum */
    return reach * 2.0 * back * step / (back + step);
}

const struct convection_scheme convection_van_leer = {
    .name = "van-leer",
    .what = "second order where smooth, bounded where not",
    .equations = "VanLeer74",
    .function = "beyond_van_leer",
    .keys = {velocity_gradient_keys},
    .owner_weights = convection_upwind_weights,
    .deferred = beyond_van_leer,
    .order = 2.0,
    .error = 1.0 / 3.0,
    .least = {1.7, 1.0},
    .time = 1.4,
};

const struct convection_scheme *const convection_schemes[] = {
    &convection_upwind,        &convection_linear,   &convection_blended,
    &convection_second_upwind, &convection_van_leer, NULL};

MODEL_NAMED(convection_scheme)
