/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/curve.h"

#include "base/alloc.h"
#include "study/statistics.h"

#include <math.h>
#include <stdlib.h>

struct curve curve_create(int n)
{
    return (struct curve){n, alloc_doubles(n), alloc_doubles(n),
                          alloc_doubles(n)};
}

void curve_free(struct curve *c)
{
    free(c->x);
    free(c->value);
    free(c->error);
    *c = (struct curve){0};
}

double curve_at(const struct curve *c, double x)
{
    if (c->n == 1) return c->value[0];
    return c->n > 1 ? statistics_between(c->n, c->x, c->value, x) : NAN;
}

double curve_difference(const struct curve *a, const struct curve *b)
{
    double sum = 0.0;

    for (int i = 0; i < b->n; i++) {
        const double d = curve_at(a, b->x[i]) - b->value[i];
        if (isfinite(d)) sum += d * d;
    }
    return sqrt(sum);
}
