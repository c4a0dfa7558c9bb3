/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/time_scheme.h"

#include "base/model.h"

static struct time_weights weights_euler(double r)
{
    (void)r;
    return (struct time_weights){1.0, 1.0, 0.0, 0.0};
}

const struct time_scheme time_scheme_euler = {
    .name = "euler",
    .what = "implicit Euler: first order, never rings",
    .equations = "XS11",
    .function = "weights_euler",
    .time_levels = 1,
    .weights = weights_euler,
};

/* The derivative at the end of the parabola through three time levels. With r =
 * 0 it is that of the line through the last two: the first step is implicit
 * Euler. */
static struct time_weights weights_bdf2(double r)
{
    return (struct time_weights){(1.0 + 2.0 * r) / (1.0 + r), 1.0 + r,
                                 r * r / (1.0 + r), r};
}

const struct time_scheme time_scheme_bdf2 = {
    .name = "bdf2",
    .what = "backward differences over two steps: second order",
    .equations = "Curtiss52",
    .function = "weights_bdf2",
    .time_levels = 2,
    .pending = 0.5, /* 1/3 + 1/9 + ... */
    .weights = weights_bdf2,
};

const struct time_scheme *const time_schemes[] = {&time_scheme_euler,
                                                  &time_scheme_bdf2, NULL};

MODEL_NAMED(time_scheme)
