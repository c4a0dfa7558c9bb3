/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/case_effects.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/cohesion/case_cohesion.h"
#include "case/checks/case_cost.h"
#include "case/checks/case_limits.h"
#include "case/table_numbers.h"
#include "coupling/effects.h"
#include "coupling/stability/stability.h"
#include "dem/attraction.h"

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

    return 1e-9 * ns * in->end / in->dt / case_cost_of(in, flow);
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
        const int named = table_numbers_of_effect(s, e, numbers);

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
    if (case_limits_no_contacts(s)) return s->exchange.two_way ? 2 : 1;
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

void case_effects_print(const struct settings *s, const struct case_scales *in)
{
    struct effect_scales k = case_effects_scales(s, in);

    if (!(k.force > 0.0)) return;
    puts("Effects, over the larger one of gravity and drag; their time, over "
         "the run's");
    print_effects(s, &k, in);
    if (s->has.exchange) print_coupling(s, &k, in->particles);
}
