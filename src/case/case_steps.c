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

/* [s] of a step of the loop, before it is rounded to whole particle steps, and
 * the key that gives it. */
static double interval(const struct settings *s, const char **key)
{
    static const char *const written[] = {"output.history", "output.every"};
    double shortest = HUGE_VAL;

    *key = "fluid.step";
    if (settings_has(s, *key)) return settings_real(s, *key);
    *key = "particles.step";
    if (has_population(s)) return POPULATION_STEPS * settings_real(s, *key);
    for (int i = 0; i < 2; i++)
        if (settings_has(s, written[i]) &&
            settings_real(s, written[i]) < shortest) {
            *key = written[i];
            shortest = settings_real(s, *key);
        }
    return shortest;
}

/* Without a fluid a step is the whole number of particle steps that is nearest
 * to the shortest time between two rows or pictures, or to the end if that
 * comes first. Thus the output does not change the motion. */
double case_steps_length(const struct settings *s)
{
    const char *key;
    const double given = interval(s, &key);

    if (s->has.fluid) return given;
    const double dt = fmin(given, settings_real(s, end_key));
    if (!settings_has(s, "particles")) return dt;
    const double step = settings_real(s, "particles.step");
    const double whole = step * fmax(1.0, round(dt / step));
    return fabs(whole - dt) > 1e-9 * dt ? whole : dt; /* but for rounding */
}

static double case_steps_particle_steps(const struct settings *s)
{
    if (!settings_has(s, "particles")) return 0.0;
    const double n = case_steps_length(s) / settings_real(s, "particles.step");
    if (!s->has.fluid) return fmax(1.0, round(n));
    return fmax(1.0, ceil(n * (1.0 - 1e-12))); /* 5.000000000001 is 5 */
}

int case_steps_within(const struct settings *s)
{
    return number_clamped(case_steps_particle_steps(s), 0, INT_MAX);
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
    return s->has.fluid ? 1 : case_steps_between(s, "output.every");
}

int case_steps_check(const struct settings *s)
{
    const double dt = case_steps_length(s);
    const char *key;
    int particle_steps;
    long steps;

    interval(s, &key);
    if (number_long(until_end(s), &steps) != 0)
        return settings_wrong(s, end_key,
                              "%g s are %.3g steps of %g s, by %s; no more "
                              "than 9e15 steps can be counted",
                              settings_real(s, end_key), until_end(s), dt, key);
    if (steps < 1)
        return settings_wrong(s, end_key,
                              "%g s is less than half of one step of %g s, by "
                              "%s: nothing would be computed",
                              settings_real(s, end_key), dt, key);
    if (number_int(case_steps_particle_steps(s), &particle_steps) != 0)
        return settings_wrong(s, "particles.step",
                              "%g s would be %.3g particle steps in one step "
                              "of %g s, by %s; expected at most %d",
                              settings_real(s, "particles.step"),
                              case_steps_particle_steps(s), dt, key, INT_MAX);
    return 0;
}
