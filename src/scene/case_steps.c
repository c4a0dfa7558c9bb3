/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/case_steps.h"

#include <limits.h>
#include <math.h>

#include "base/number.h"

static const char end_key[] = "output.end";

/* The key that says how long a step of the loop is. */
static const char *length_key(const struct settings *s)
{
    if (settings_has(s, "fluid")) return "fluid.step";
    return settings_has(s, "output.history") ? "output.history"
                                             : "output.every";
}

/* Without a fluid nothing asks for steps that are longer than the run. */
double case_steps_length(const struct settings *s)
{
    const double dt = settings_real(s, length_key(s));

    return settings_has(s, "fluid") ? dt : fmin(dt, settings_real(s, end_key));
}

static double within(const struct settings *s)
{
    if (!settings_has(s, "particles")) return 0.0;
    const double n = case_steps_length(s) / settings_real(s, "particles.step");
    return fmax(1.0, ceil(n * (1.0 - 1e-12))); /* 5.000000000001 is 5 */
}

int case_steps_within(const struct settings *s)
{
    return number_clamped(within(s), 0, INT_MAX);
}

static double until_end(const struct settings *s)
{
    return round(settings_real(s, end_key) / case_steps_length(s));
}

long case_steps_until_end(const struct settings *s)
{
    long n = 0;

    number_long(until_end(s), &n);
    return n;
}

/* An interval of more steps than can be counted is longer than any run. */
long case_steps_between(const struct settings *s, const char *path)
{
    long n = LONG_MAX;

    number_long(round(settings_real(s, path) / case_steps_length(s)), &n);
    return n < 1 ? 1 : n;
}

int case_steps_check(const struct settings *s)
{
    const double dt = case_steps_length(s);
    int particle_steps;
    long steps;

    if (number_long(until_end(s), &steps) != 0)
        return settings_wrong(s, end_key,
                              "%g s are %.3g steps of %g s, by %s; no more "
                              "than 9e15 can be told from each other",
                              settings_real(s, end_key), until_end(s), dt,
                              length_key(s));
    if (steps < 1)
        return settings_wrong(s, end_key,
                              "%g s is less than half of one step of %g s, by "
                              "%s: nothing would be computed",
                              settings_real(s, end_key), dt, length_key(s));
    if (number_int(within(s), &particle_steps) != 0)
        return settings_wrong(s, "particles.step",
                              "%g s would be %.3g particle steps in one step "
                              "of %g s, by %s; expected at most %d",
                              settings_real(s, "particles.step"), within(s), dt,
                              length_key(s), INT_MAX);
    return 0;
}
