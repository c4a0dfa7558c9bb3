/* SPDX-License-Identifier: GPL-3.0-or-later */
/* effects.c -- which effects a case calls for: the scales of its motion, and
 * the estimates that effects make from them.  Chapter "Further forces". */
#include "tell/check.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "case/checks/case_scales.h"
#include "case/particles/case_cohesion.h"
#include "case/fill.h"
#include "coupling/drag.h"
#include "coupling/effects.h"
#include "coupling/stability.h"
#include "dem/attraction.h"

/* What was measured in beds of gas and of water: the share of the slip by which
 * a grain's velocity changes in the time of a fall over its diameter, most of
 * it by contacts [-], and its spin over slip/d [-]. */
static const double stirred = 0.3, spun = 0.1;

/* The mean diameter [m], velocity [m/s] and spin [rad/s] of placed spheres. */
struct placed {
    double d, speed, spin;
};

static struct placed placed_of(const struct settings *s,
                               const struct case_scales *in)
{
    const int n = s->particles.place.n;
    struct placed p = {0.0, 0.0, 0.0};

    if (n == 0) /* all of them are inserted */
        return (struct placed){.d = 0.5 * (in->d + in->d_most),
                               .speed = case_scales_initial_speed(s)};

    for (int i = 0; i < n; i++) {
        const struct place_setup *const one = &s->particles.place.item[i];
        p.d += one->diameter / n;
        p.speed += vector_length(one->velocity) / n;
        p.spin += vector_length(one->spin) / n;
    }
    return p;
}

/* The fastest moving wall over the narrowest way across the box [1/s]. */
static double shear_of_walls(const struct settings *s)
{
    double lo[3], size[3], fastest = 0.0;

    case_mesh_ends(s, lo, size);
    for (int i = 0; i < s->sides.n; i++)
        fastest = fmax(fastest, vector_length(s->sides.item[i].wall));
    return fastest / fmin(size[0], fmin(size[1], size[2]));
}

static double effect_scales_volume(const struct effect_scales *k)
{
    return M_PI / 6.0 * gsl_pow_3(k->d);
}

/* Drag [N] at a slip w where eps_s is solid. */
static double drag_at(const struct settings *s, const struct effect_scales *k,
                      double eps_s, double w)
{
    const struct drag_law law = build_drag_law(s);

    return effect_scales_volume(k) * w *
           drag_resistance(&law, 1.0 - eps_s, k->rho_f, k->mu, k->d, w);
}

/* The slip at which the drag carries the weight less the buoyancy. */
static double terminal(const struct settings *s, const struct effect_scales *k,
                       double eps_s)
{
    const double pull =
        fabs(k->rho_s - k->rho_f) * effect_scales_volume(k) * k->gravity;
    double low = 0.0, high = 1e3;

    for (int i = 0; i < 100; i++) {
        const double w = 0.5 * (low + high);
        if (drag_at(s, k, eps_s, w) / (1.0 - eps_s) < pull)
            low = w;
        else
            high = w;
    }
    return low;
}

/* The solids fraction at which a stream of this superficial velocity carries
 * the particles: `CHECK_PACKED` if it does not. */
static double expanded(const struct settings *s, const struct effect_scales *k,
                       double inlet)
{
    double low = 0.0, high = CHECK_PACKED;

    if (terminal(s, k, CHECK_PACKED) * (1.0 - CHECK_PACKED) > inlet)
        return CHECK_PACKED;
    for (int i = 0; i < 60; i++) {
        const double eps_s = 0.5 * (low + high);
        if (terminal(s, k, eps_s) * (1.0 - eps_s) > inlet)
            low = eps_s;
        else
            high = eps_s;
    }
    return low;
}

/* A bed in a stream: fluidized, or at rest. In it the gas velocity changes by
 * the slip over a few cells between bubbles, and particles behind a bubble fall
 * for the time of a diameter. In a bed at rest the slip changes only when the
 * stream begins. */
static void bed_scales(const struct settings *s, struct effect_scales *k,
                       const struct case_scales *in)
{
    k->eps_s = in->inlet > 0.0 ? expanded(s, k, in->inlet) : CHECK_PACKED;
    k->carried = k->eps_s < CHECK_PACKED;
    k->slip = in->inlet / (1.0 - k->eps_s);
    k->length = 2.0 * in->S_c;
    k->shear = k->slip / k->length;
    if (!k->carried) { /* the stream begins, and then nothing changes */
        k->time = in->end;
        k->acceleration = k->slip / k->time;
        return;
    }
    k->spin = spun * k->slip / k->d;
    k->time = sqrt(k->d / k->gravity);
    k->acceleration = stirred * k->slip / k->time * fabs(k->rho_s - k->rho_f) /
                      (k->rho_s + 0.5 * k->rho_f);
}

/* Spheres that are far from each other: they fall, or the stream carries them.
 */
static void dilute_scales(const struct settings *s, struct effect_scales *k,
                          const struct case_scales *in, const struct placed *p)
{
    double lo[3], size[3];

    case_mesh_ends(s, lo, size);
    k->eps_s = in->particles * effect_scales_volume(k) / case_mesh_volume(s);
    k->slip = fmax(in->inlet, p->speed);
    if (k->gravity > 0.0)
        k->slip = fmax(p->speed, fmin(terminal(s, k, k->eps_s),
                                      0.5 * k->gravity * in->end));
    if (k->slip == 0.0 && k->mu > 0.0) /* of the push alone */
        k->slip = k->mean_gradient * k->d * k->d / (18.0 * k->mu);
    k->carried = 1;
    k->length = 0.5 * fmin(size[0], fmin(size[1], size[2]));
    k->shear = shear_of_walls(s);
    if (k->mean_gradient > 0.0 && k->mu > 0.0) /* at the wall of a channel */
        k->shear = fmax(k->shear, k->mean_gradient * k->length / k->mu);
    k->spin = p->spin;
    k->time = s->output.end;
    k->acceleration = k->slip / k->time;
    if (k->gravity == 0.0) k->time = 0.0; /* the slip dies out within tau */
}

/* A slip that dies out does so within tau. Of its history force the two parts,
 * of the first slip and of its decay, have opposite signs, and leave a quarter
 * of the size: that of a 16th of the time. */
static void settle_time(struct effect_scales *k)
{
    if (k->time == 0.0) {
        k->acceleration = k->slip / k->tau;
        k->time = k->tau / 16.0;
    }
    k->acceleration = fmin(k->acceleration, k->slip / k->time);
}

/* Placed grains that are so many that they form a bed in the stream. */
static int is_crowd(const struct settings *s, const struct effect_scales *k,
                    const struct case_scales *in)
{
    const double crowd = 0.05; /* [-] of the whole mesh */

    return in->inlet > 0.0 && k->gravity > 0.0 &&
           in->particles * effect_scales_volume(k) >
               crowd * case_mesh_volume(s);
}

static struct effect_scales effects_scales_of(const struct settings *s,
                                              const struct case_scales *in)
{
    const struct placed p = placed_of(s, in);
    struct effect_scales k = {
        .rho_s = s->particles.grains.density,
        .d = in->volume > 0.0 ? cbrt(6.0 / M_PI * in->volume / in->particles)
                              : p.d,
        .gravity = vector_length(s->effects.gravity)};

    k.weight = k.rho_s * effect_scales_volume(&k) * k.gravity;
    if (s->has.exchange) {
        k.mean_gradient = vector_length(s->fluid.mean_gradient);
        k.rho_f = s->fluid.rho;
        k.mu = s->fluid.mu;
        k.dt = in->dt;
        if (in->volume > 0.0 || is_crowd(s, &k, in))
            bed_scales(s, &k, in);
        else
            dilute_scales(s, &k, in, &p);
        k.drag = drag_at(s, &k, k.eps_s, k.slip);
        k.tau = k.slip > 0.0
                    ? k.rho_s * effect_scales_volume(&k) * k.slip / k.drag
                    : 0.0;
        settle_time(&k);
    }
    k.force = fmax(k.weight, k.drag);
    return k;
}

/* [-] of the larger one of weight and drag: an effect below the first may be
 * left out, one above the second may not. */
static const double small = 0.01, large = 0.05;

static const char *verdict(int named, const struct effect_estimate *e)
{
    if (named) return e->share < small ? "named, but small" : "named";
    if (e->conditional) return "off";
    return e->share < small   ? "off, small"
           : e->share < large ? "off, worth a try"
                              : "off, CALLED FOR";
}

static void case_effects_line(const char *name, double value, const char *unit,
                              const char *verdict_or_remark, const char *remark)
{
    printf("  %-38s %10.4g %-4s %s%s%s\n", name, value, unit, verdict_or_remark,
           remark[0] != '\0' ? ": " : "", remark);
}

/* The attraction of an effect among those of the case, or NULL. */
static const struct attraction *
case_effects_pair_of(const struct effect *e, const double *numbers,
                     const struct attraction *all, int n)
{
    static const double none = 0.0;
    const struct attraction_scene scene = {.charge = &none};

    if (e->attraction == NULL) return NULL;
    const struct attraction_law *const law = e->attraction(numbers, &scene).law;
    for (int k = 0; k < n; k++)
        if (all[k].law == law) return &all[k];
    return NULL;
}

/* 1 if the case has what the effect needs. */
static int case_effects_applies(const struct settings *s,
                                const struct effect *e)
{
    return strstr(e->keys[0]->needs, "fluid") == NULL || s->has.exchange;
}

/* 1 if the case names an effect that takes the place of this one. */
static int is_replaced(const struct settings *s, const struct effect *e)
{
    for (int i = 0; effects[i] != NULL; i++) {
        const struct key *const key = effects[i]->keys[0];
        const char *const instead = strchr(key->needs, '!');
        if (instead != NULL && strcmp(instead + 1, e->keys[0]->path) == 0 &&
            settings_has(s, key->path))
            return 1;
    }
    return 0;
}

/* The time of the effect over that of the whole run without it [-]. */
static double case_effects_cost_of(const struct effect *e,
                                   const struct case_scales *in, int flow)
{
    const double each =
        e->cost.particle + e->cost.particle_step * in->dem_steps;
    const double ns = in->particles * each + in->cells * e->cost.cell;

    return 1e-9 * ns * in->end / in->dt / case_scales_cost(in, flow);
}

static void effect_line(const struct effect *e, double cost, const char *words,
                        const struct effect_estimate *estimate)
{
    char told[160];

    snprintf(told, sizeof told, "%7.3g %%   %s", 100.0 * cost, words);
    case_effects_line(e->name, 100.0 * estimate->share, "%", told,
                      estimate->remark);
}

static void print_effects(const struct settings *s, struct effect_scales *k,
                          const struct case_scales *in)
{
    int n;
    struct attraction *const all = case_cohesion_create(s, &n);

    for (int i = 0; effects[i] != NULL; i++) {
        const struct effect *const e = effects[i];
        double numbers[EFFECT_NUMBERS];
        const int named = fill_effect_numbers(s, e, numbers);

        if (!case_effects_applies(s, e) || (e->estimate == NULL && !named))
            continue;
        if (e->estimate == NULL) {
            printf("  %-38s %10s %-4s %7.3g %%   named; no estimate\n", e->name,
                   "-", "",
                   100.0 * case_effects_cost_of(e, in, k->rho_f > 0.0));
            continue;
        }
        k->numbers = named ? numbers : NULL;
        k->pair = named ? case_effects_pair_of(e, numbers, all, n) : NULL;
        const struct effect_estimate estimate = e->estimate(k);
        effect_line(e, case_effects_cost_of(e, in, k->rho_f > 0.0),
                    is_replaced(s, e) ? "off, replaced"
                                      : verdict(named, &estimate),
                    &estimate);
    }
    free(all);
}

/* The coupling that Elghobashi's map asks for: one-way below a solids fraction
 * of 1e-6, two-way below 1e-3, where collisions are rare, and else four-way. A
 * single particle does not collide. */
static int ways_called_for(double eps_s, int particles)
{
    if (eps_s <= 1e-6) return 1;
    return eps_s > 1e-3 && particles > 1 ? 4 : 2;
}

/* Particles that collide but do not act on the fluid are neither one-way nor
 * four-way coupled: 0. */
static int ways_of(const struct settings *s)
{
    if (case_scales_no_contacts(s)) return s->exchange.two_way ? 2 : 1;
    return s->exchange.two_way ? 4 : 0;
}

static void print_ways(const struct settings *s, int needed)
{
    static const char *const only[] = {
        [1] = "exchange.coupling = \"one-way\", particles.list = \"none\"",
        [2] = "particles.list = \"none\"",
        [4] = "exchange.coupling = \"two-way\", and a particles.list"};
    const int has = ways_of(s);

    case_effects_line(
        "ways of the coupling", needed, "-",
        has == needed  ? "as it is"
        : has == 0     ? "contacts without a reaction on the fluid; CALLED FOR"
        : has > needed ? "more than is called for; enough would be"
                       : "CALLED FOR",
        has == needed ? "" : only[needed]);
}

static void print_coupling(const struct settings *s,
                           const struct effect_scales *k, int particles)
{
    const int needed = ways_called_for(k->eps_s, particles);

    case_effects_line("solids fraction", k->eps_s, "-",
                      k->eps_s > 1e-3 ? "over 1e-3: particles collide"
                      : k->eps_s > 1e-6
                          ? "1e-6 to 1e-3: particles act on the fluid"
                          : "below 1e-6: particles do not act on the fluid",
                      "");
    case_effects_line("mass loading",
                      stability_loading(k->rho_s, k->eps_s, k->rho_f), "-",
                      "of the particles over the fluid where they are", "");
    print_ways(s, needed);
}

void check_effects(const struct settings *s, const struct case_scales *in)
{
    struct effect_scales k = effects_scales_of(s, in);

    if (!(k.force > 0.0)) return;
    puts("Effects, over the larger one of gravity and drag; their time, over "
         "the run's");
    print_effects(s, &k, in);
    if (s->has.exchange) print_coupling(s, &k, in->particles);
}
