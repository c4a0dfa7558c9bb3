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

static double between(const struct curve *c, const double *y, double x)
{
    if (c->n == 1) return y[0];
    return c->n > 1 ? statistics_between(c->n, c->x, y, x) : NAN;
}

double curve_at(const struct curve *c, double x, double *error)
{
    if (error != NULL) *error = between(c, c->error, x);
    return between(c, c->value, x);
}

struct curve curve_mean(int n, const struct curve *of)
{
    struct curve mean = curve_create(of[0].n);
    double *const q = alloc_doubles(n);

    for (int i = 0; i < mean.n; i++) {
        double squares = 0.0;
        for (int k = 0; k < n; k++) {
            const int same = of[k].n == mean.n;
            q[k] = same ? of[k].value[i] : curve_at(&of[k], of[0].x[i], NULL);
            squares += same ? of[k].error[i] * of[k].error[i] : 0.0;
        }
        mean.x[i] = of[0].x[i];
        mean.value[i] = statistics_mean(n, q);
        mean.error[i] = fmax(sqrt(squares) / n, statistics_error(n, q));
    }
    free(q);
    return mean;
}

double curve_changes(const struct curve *a, const struct curve *b,
                     const struct curve *c)
{
    double first = 0.0, last = 0.0, both = 0.0, chance = 0.0;

    for (int i = 0; i < c->n; i++) {
        double e;
        const double q = curve_at(b, c->x[i], &e);
        const double from = q - curve_at(a, c->x[i], NULL);
        const double to = c->value[i] - q;
        if (!isfinite(from) || !isfinite(to)) continue;
        first += from * from;
        last += to * to;
        both += from * to;
        chance += e * e + c->error[i] * c->error[i];
    }
    return last > 4.0 * chance ? copysign(sqrt(first / last), both) : NAN;
}
