/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/convection.h"

#include <stddef.h>
#include <string.h>

static double share_upwind(double phi, double w)
{
    (void)w;
    return phi >= 0.0 ? 1.0 : 0.0;
}

static double share_linear(double phi, double w)
{
    (void)phi;
    return w;
}

const struct convection_scheme convection_schemes[] = {
    {"upwind", "XS11", "first order, bounded at any step", share_upwind},
    {"linear", "XS11", "second order (central), may overshoot", share_linear},
    {NULL, NULL, NULL, NULL}};

const struct convection_scheme *convection_scheme_named(const char *name)
{
    for (const struct convection_scheme *s = convection_schemes;
         s->name != NULL; s++)
        if (strcmp(s->name, name) == 0) return s;
    return NULL;
}
