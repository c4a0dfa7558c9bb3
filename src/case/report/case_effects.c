/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/case_effects.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/case_cohesion.h"
#include "case/table_numbers.h"
#include "coupling/effects.h"
#include "coupling/stability.h"
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

static void line(const char *name, double value, const char *unit,
                 const char *verdict_or_remark, const char *remark)
{
    printf("  %-38s %10.4g %-4s %s%s%s\n", name, value, unit, verdict_or_remark,
           remark[0] != '\0' ? ": " : "", remark);
}

/* The attraction of an effect among those of the case, or NULL. */
static const struct attraction *pair_of(const struct effect *e,
                                        const double *numbers,
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
static int applies(const struct settings *s, const struct effect *e)
{
    return strstr(e->keys[0].needs, "fluid") == NULL ||
           settings_has(s, "exchange");
}

static void print_effects(const struct settings *s, struct effect_scales *k)
{
    int n;
    struct attraction *const all = case_cohesion_create(s, &n);

    for (int i = 0; effects[i] != NULL; i++) {
        const struct effect *const e = effects[i];
        const int named = settings_has(s, e->keys[0].path);
        double numbers[16] = {0.0};

        if (e->estimate == NULL || !applies(s, e)) continue;
        if (named) table_numbers(s, e->keys, numbers, 16);
        k->numbers = named ? numbers : NULL;
        k->pair = named ? pair_of(e, numbers, all, n) : NULL;
        const struct effect_estimate estimate = e->estimate(k);
        line(e->name, 100.0 * estimate.share, "%", verdict(named, &estimate),
             estimate.remark);
    }
    free(all);
}

/* Elghobashi's map: below 1e-6 the fluid does not feel the particles, below
 * 1e-3 these do not meet. */
static void print_coupling(const struct settings *s,
                           const struct effect_scales *k)
{
    const char *const has = settings_text(s, "exchange.coupling");
    const int needed = k->eps_s > 1e-3 ? 4 : k->eps_s > 1e-6 ? 2 : 1;
    const int one_way = strcmp(has, "one-way") == 0;

    line("solids fraction", k->eps_s, "-",
         needed == 4   ? "over 1e-3: four-way, they meet"
         : needed == 2 ? "1e-6 to 1e-3: two-way, the fluid feels them"
                       : "below 1e-6: one-way will do",
         one_way && needed > 1 ? "exchange.coupling is one-way" : "");
    line("mass loading", stability_loading(k->rho_s, k->eps_s, k->rho_f), "-",
         "of the particles over the fluid where they are", "");
}

void case_effects_print(const struct settings *s, const struct case_scales *in)
{
    struct effect_scales k = case_effects_scales(s, in);

    if (!(k.force > 0.0)) return;
    puts("Effects, over the larger one of gravity and drag");
    print_effects(s, &k);
    if (settings_has(s, "exchange")) print_coupling(s, &k);
}
