/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_steps.h"

#include <limits.h>
#include <math.h>

#include "base/number.h"

static const char end_key[] = "output.end";

/* Particle steps between two insertions and removals where there is no fluid.
 */
enum { POPULATION_STEPS = 20 };

static int has_population(const struct settings *s)
{
    return settings_has(s, "particles.insert") ||
           settings_has(s, "particles.sinks");
}

/* The key that says how long a step of the loop is. */
static const char *length_key(const struct settings *s)
{
    if (settings_has(s, "fluid")) return "fluid.step";
    if (has_population(s)) return "particles.step";
    return settings_has(s, "output.history") ? "output.history"
                                             : "output.every";
}

/* Without a fluid a step is the whole number of particle steps that is nearest
 * to the time between two rows, or to the end if that comes first. So what is
 * written does not change how the particles move. */
static double nearest_whole(const struct settings *s, double interval)
{
    const double dt = fmin(interval, settings_real(s, end_key));

    if (!settings_has(s, "particles")) return dt;
    const double step = settings_real(s, "particles.step");
    const double whole = step * fmax(1.0, round(dt / step));
    return fabs(whole - dt) > 1e-9 * dt ? whole : dt; /* but for rounding */
}

double case_steps_length(const struct settings *s)
{
    const double dt = settings_real(s, length_key(s));

    if (!settings_has(s, "fluid") && has_population(s))
        return nearest_whole(s, POPULATION_STEPS * dt);
    return settings_has(s, "fluid") ? dt : nearest_whole(s, dt);
}

static double within(const struct settings *s)
{
    if (!settings_has(s, "particles")) return 0.0;
    const double n = case_steps_length(s) / settings_real(s, "particles.step");
    if (!settings_has(s, "fluid")) return fmax(1.0, round(n));
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

long case_steps_between_rows(const struct settings *s)
{
    if (settings_has(s, "output.history"))
        return case_steps_between(s, "output.history");
    return settings_has(s, "fluid") ? 1 : case_steps_between(s, "output.every");
}

int case_steps_check(const struct settings *s)
{
    const double dt = case_steps_length(s);
    int particle_steps;
    long steps;

    if (number_long(until_end(s), &steps) != 0)
        return settings_wrong(s, end_key,
                              "%g s are %.3g steps of %g s, by %s; no more "
                              "than 9e15 steps can be counted",
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
