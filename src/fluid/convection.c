/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/convection.h"

#include "fluid/fluid.h"

#include "base/model.h"
#include "fluid/velocity_gradient.h"

void convection_upwind_weights(const struct convection_faces *faces,
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
     .at = KEY_AT(fluid_options, blend)},
    KEY_END};

const struct convection_scheme convection_blended = {
    .name = "blended",
    .what = "fluid.blend of linear, the rest upwind",
    .equations = "",
    .function = "weights_blended",
    .keys = {blend_keys},
    .owner_weights = weights_blended,
};

const struct convection_scheme *const convection_schemes[] = {
    &convection_upwind,        &convection_linear,   &convection_blended,
    &convection_second_upwind, &convection_van_leer, NULL};

MODEL_NAMED(convection_scheme)
const struct velocity_gradient_scheme *const velocity_gradient_schemes[] = {
    &velocity_gradient_by_mesh, &velocity_gradient_gauss,
    &velocity_gradient_least_squares, NULL};

MODEL_NAMED(velocity_gradient_scheme)
