/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/convection.h"

#include <stddef.h>
#include <string.h>

static void weights_upwind(const struct convection_faces *faces, double *share)
{
    for (int f = 0; f < faces->n; f++)
        share[f] = faces->phi[f] >= 0.0 ? 1.0 : 0.0;
}

static void weights_linear(const struct convection_faces *faces, double *share)
{
    for (int f = 0; f < faces->n; f++)
        share[f] = faces->w[f];
}

static void weights_blended(const struct convection_faces *faces, double *share)
{
    const double b = faces->blend;

    for (int f = 0; f < faces->n; f++)
        share[f] =
            b * faces->w[f] + (1.0 - b) * (faces->phi[f] >= 0.0 ? 1.0 : 0.0);
}

/* Linear extrapolation from C to the face with the gradient in C. */
static double beyond_second_upwind(double step, double rise, double reach)
{
    (void)step;
    return reach * rise;
}

/* The gradient in C and that of the link limit each other [VanLeer74]: with r =
 * (u_C - u_B) / (u_D - u_C) relative to C, B being as far upstream as D is
 * downstream, psi = (r + |r|) / (1 + r) of the linear step is taken. */
static double beyond_van_leer(double step, double rise, double reach)
{
    const double back = 2.0 * rise - step; /* u_C - u_B */

    if (back * step <= 0.0) return 0.0; /* C is an extremum */
    return reach * 2.0 * back * step / (back + step);
}

const struct convection_scheme convection_schemes[] = {
    {"upwind", "XS11", "first order, bounded at any step", "weights_upwind",
     weights_upwind, NULL, 1},
    {"linear", "XS11", "second order (central), may overshoot",
     "weights_linear", weights_linear, NULL, 0},
    {"blended", "", "fluid.blend of linear, the rest upwind", "weights_blended",
     weights_blended, NULL, 0},
    {"second-upwind", "SX15",
     "second order, looks upstream only; may overshoot", "beyond_second_upwind",
     weights_upwind, beyond_second_upwind, 0},
    {"van-leer", "VanLeer74", "second order where smooth, bounded where not",
     "beyond_van_leer", weights_upwind, beyond_van_leer, 0},
    {NULL, NULL, NULL, NULL, NULL, NULL, 0}};

const struct convection_scheme *convection_scheme_named(const char *name)
{
    for (const struct convection_scheme *s = convection_schemes;
         s->name != NULL; s++)
        if (strcmp(s->name, name) == 0) return s;
    return NULL;
}
