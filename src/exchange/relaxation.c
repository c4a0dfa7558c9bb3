/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "exchange/relaxation.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* Below x = 1 the closed form loses digits; the series 1/2! - x/3! + x^2/4!
 * - ... has all of them after eighteen terms. */
double relaxation_lag(double x)
{
    double term = 0.5, sum = 0.5;

    if (x > 1.0) return (x + expm1(-x)) / x / x;
    for (int n = 3; n <= 20; n++) {
        term *= -x / n;
        sum += term;
    }
    return sum;
}

static double no_lag(double x)
{
    (void)x;
    return 0.0;
}

const struct relaxation relaxations[] = {
    {"frozen", "XS11 3.18", "the drag of the sub-step's start, throughout it",
     no_lag},
    {"exponential", "XS11 3.16",
     "the drag that relaxes as the particle gives in to it", relaxation_lag},
    {NULL, NULL, NULL, NULL}};

const struct relaxation *relaxation_named(const char *name)
{
    for (const struct relaxation *r = relaxations; r->name != NULL; r++)
        if (strcmp(r->name, name) == 0) return r;
    return NULL;
}
