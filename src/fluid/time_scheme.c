/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/time_scheme.h"

#include <stddef.h>
#include <string.h>

static struct time_weights weights_euler(double r)
{
    (void)r;
    return (struct time_weights){1.0, 1.0, 0.0, 0.0};
}

/* The derivative at the end of the parabola through three time levels. With r =
 * 0 it is that of the line through the last two: the first step is implicit
 * Euler. */
static struct time_weights weights_bdf2(double r)
{
    return (struct time_weights){(1.0 + 2.0 * r) / (1.0 + r), 1.0 + r,
                                 r * r / (1.0 + r), r};
}

const struct time_scheme time_schemes[] = {
    {"euler", "XS11", "implicit Euler: first order, never rings",
     "weights_euler", 1, weights_euler},
    {"bdf2", "Curtiss52", "backward differences over two steps: second order",
     "weights_bdf2", 2, weights_bdf2},
    {NULL, NULL, NULL, NULL, 0, NULL}};

const struct time_scheme *time_scheme_named(const char *name)
{
    for (const struct time_scheme *s = time_schemes; s->name != NULL; s++)
        if (strcmp(s->name, name) == 0) return s;
    return NULL;
}
