/* SPDX-License-Identifier: GPL-3.0-or-later */
/* second_order.c -- schemes of convection with the gradient of the cell C from
 * which the fluid comes: upwind in the matrix, the rest deferred.
 */
#include "fluid/convection.h"

#include "fluid/velocity_gradient.h"

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
};
