/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_file.h"

#include <limits.h>
#include <math.h>

#include "base/number.h"

/* Particle steps between two insertions and removals where there is no fluid.
 */
enum { POPULATION_STEPS = 20 };

/* [s] of a step of the loop, before it is rounded to whole particle steps, and
 * the key that gives it. */
static double case_steps_given(const struct settings *s, const char **key)
{
    const double every = s->output.every;
    const double history =
        s->output.history > 0.0 ? s->output.history : HUGE_VAL;

    *key = "fluid.step";
    if (s->has.fluid) return s->fluid.dt;
    *key = "particles.step";
    if (s->effects.particle_stress) return s->particles.step;
    if (s->particles.has_insert || s->particles.has_sinks)
        return POPULATION_STEPS * s->particles.step;
    *key = history <= every ? "output.history" : "output.every";
    return fmin(history, every);
}

/* Without a fluid a step is the whole number of particle steps that is nearest
 * to the shortest time between two rows or pictures, or to the end if that
 * comes first. Thus the output does not change the motion. */
double case_steps_length(const struct settings *s)
{
    const char *key;
    const double given = case_steps_given(s, &key);

    if (s->has.fluid) return given;
    const double dt = fmin(given, s->output.end);
    if (!s->has.particles) return dt;
    const double step = s->particles.step;
    const double whole = step * fmax(1.0, round(dt / step));
    return fabs(whole - dt) > 1e-9 * dt ? whole : dt; /* but for rounding */
}

static double case_steps_particle_steps(const struct settings *s)
{
    if (!s->has.particles) return 0.0;
    const double n = case_steps_length(s) / s->particles.step;
    if (!s->has.fluid) return fmax(1.0, round(n));
    return fmax(1.0, ceil(n * (1.0 - 1e-12))); /* 5.000000000001 is 5 */
}

int case_steps_within(const struct settings *s)
{
    return number_clamped(case_steps_particle_steps(s), 0, INT_MAX);
}

static double until_end(const struct settings *s)
{
    return round(s->output.end / case_steps_length(s));
}

long case_steps_until_end(const struct settings *s)
{
    long n = 0;

    number_long(until_end(s), &n);
    return n;
}

/* An interval of more steps than can be counted is longer than any run. */
long case_steps_between(const struct settings *s, double interval)
{
    long n = LONG_MAX;

    number_long(round(interval / case_steps_length(s)), &n);
    return n < 1 ? 1 : n;
}

long case_steps_between_rows(const struct settings *s)
{
    const struct output_options *const o = &s->output;

    if (o->history > 0.0) return case_steps_between(s, o->history);
    return s->has.fluid ? 1 : case_steps_between(s, o->every);
}

int case_steps_check(const struct settings *s)
{
    const double dt = case_steps_length(s);
    const char *key;
    int particle_steps;
    long steps;

    case_steps_given(s, &key);
    if (number_long(until_end(s), &steps) != 0)
        return settings_wrong(s, KEY_OF(s, output.end),
                              "%g s are %.3g steps of %g s, by %s; no more "
                              "than 9e15 steps can be counted",
                              s->output.end, until_end(s), dt, key);
    if (steps < 1)
        return settings_wrong(s, KEY_OF(s, output.end),
                              "%g s is less than half of one step of %g s, by "
                              "%s: nothing would be computed",
                              s->output.end, dt, key);
    if (number_int(case_steps_particle_steps(s), &particle_steps) != 0)
        return settings_wrong(s, KEY_OF(s, particles.step),
                              "%g s would be %.3g particle steps in one step "
                              "of %g s, by %s; expected at most %d",
                              s->particles.step, case_steps_particle_steps(s),
                              dt, key, INT_MAX);
    return 0;
}
