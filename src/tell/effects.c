/* SPDX-License-Identifier: GPL-3.0-or-later */
/* effects.c -- which effects a case calls for: what each would do, as it
 * estimates that itself, its time, and a verdict.  Chapter "Further forces".
 *
 *     needed       so much is missed without it
 *     negligible   less than a twentieth is
 *     unknown      what would tell
 */
#include "tell/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "case/settings.h"
#include "case/particles/case_clumps.h"
#include "case/particles/case_materials.h"
#include "coupling/effects.h"
#include "coupling/coupling.h"
#include "dem/attraction.h"

/* [-] what is missed without an effect below which it may be left out. */
static const double noticed = 0.05;

static void print_head(void)
{
    printf("Effects, and what is missed without them\n"
           "  %-18s %9s %9s  %-3s %s\n"
           "  %-18s %9s %9s\n",
           "", "size", "time", "", "verdict", "", "%", "% of run");
}

void check_size(const struct effect_estimate *e, char text[CHECK_SIZE])
{
    snprintf(text, CHECK_SIZE, "-");
    if (isfinite(e->share))
        snprintf(text, CHECK_SIZE, "%s%.3g", e->bound ? "<" : "",
                 100.0 * e->share);
}

static void print_row(const char *name, const struct effect_estimate *e,
                      double time, int on, const char *verdict)
{
    char cell[2][CHECK_SIZE] = {"-", "-"};

    check_size(e, cell[0]);
    if (isfinite(time)) snprintf(cell[1], sizeof cell[1], "%.3g", time);
    printf("  %-18s %9s %9s  %-3s %s\n", name, cell[0], cell[1],
           on ? "on" : "off", verdict);
}

void check_verdict(const struct effect_row *r, char text[CHECK_VERDICT])
{
    const struct effect_estimate *const e = &r->estimate;
    const char *const colon = e->remark[0] != '\0' ? "; " : "";

    text[0] = '\0';
    if (r->instead != NULL)
        snprintf(text, CHECK_VERDICT, "negligible: %s stands for it",
                 r->instead->name);
    else if (r->effect == &particle_stress_effect)
        snprintf(text, CHECK_VERDICT, "needed: it stands for contacts");
    else if (e->of == NULL)
        return; /* a measure, no force */
    else if (e->loss < noticed && e->share < noticed)
        snprintf(text, CHECK_VERDICT, "negligible: below %g %%%s%s",
                 100.0 * noticed, colon, e->remark);
    else if (e->loss < noticed)
        snprintf(text, CHECK_VERDICT, "negligible: %.2g %% is missed%s%s",
                 100.0 * e->loss, colon, e->remark);
    else if (r->refused)
        snprintf(text, CHECK_VERDICT,
                 "unknown: known for spheres alone, and refused with clumps");
    else if (e->unknown)
        snprintf(text, CHECK_VERDICT, "unknown: %s", e->remark);
    else
        snprintf(text, CHECK_VERDICT, "needed: %.3g %% of %s%s%s",
                 100.0 * e->loss, e->of, colon, e->remark);
}

/* The attraction of an effect among those of the case, or NULL. */
static const struct attraction *effects_pair_of(const struct effect *e,
                                                const double *numbers,
                                                const struct attraction *all,
                                                int n)
{
    static const double none = 0.0;
    const struct attraction_scene scene = {.charge = &none};

    if (e->attraction == NULL) return NULL;
    const struct attraction_law *const law = e->attraction(numbers, &scene).law;
    for (int k = 0; k < n; k++)
        if (all[k].law == law) return &all[k];
    return NULL;
}

/* The effect that stands for this one: one that excludes it and is named, or
 * that it excludes itself; NULL if there is none. */
static const struct effect *stand_in(const struct settings *s,
                                     const struct effect *e)
{
    const char *const own = strchr(e->keys[0]->needs, '!');

    for (int i = 0; effects[i] != NULL; i++) {
        const struct key *const key = effects[i]->keys[0];
        const char *const other = strchr(key->needs, '!');
        if (own != NULL && strcmp(own + 1, key->path) == 0) return effects[i];
        if (other != NULL && strcmp(other + 1, e->keys[0]->path) == 0 &&
            settings_has(s, key->path))
            return effects[i];
    }
    return NULL;
}

/* The time of the effect over that of the whole run without it [-]. */
static double effects_time_of(const struct effect *e,
                              const struct case_scales *in, int flow)
{
    const double each =
        e->cost.particle + e->cost.particle_step * in->dem_steps;
    const double ns = in->particles * each + in->cells * e->cost.cell;

    return 1e-9 * ns * in->end / in->dt / case_scales_cost(in, flow);
}

/* A grain that buoyancy nearly carries is moved by what is left of its weight.
 */
static void tell_of_net(const struct effect *e, const struct effect_scales *k,
                        struct effect_estimate *estimate)
{
    if (e == &gravity_effect || e == &pressure_gradient_effect ||
        e == &whole_drag_effect || estimate->of == NULL ||
        strcmp(estimate->of, "the force on a grain") != 0 ||
        !(k->net < 0.9 * k->force))
        return;
    estimate->loss *= k->force / k->net;
    estimate->of = "what buoyancy leaves of the weight";
}

int check_effect_rows(const struct settings *s, struct effect_scales *k,
                      const struct case_scales *in,
                      struct effect_row row[CHECK_EFFECTS])
{
    int n, rows = 0;
    struct attraction *const all = case_materials_attractions(s, &n);

    for (int i = 0; effects[i] != NULL && rows < CHECK_EFFECTS; i++) {
        const struct effect *const e = effects[i];
        double numbers[EFFECT_NUMBERS];
        const int named = fill_effect_numbers(s, e, numbers);
        const int applies =
            strstr(e->keys[0]->needs, "fluid") == NULL || s->has.exchange;

        if (!applies || (e->estimate == NULL && !named)) continue;
        struct effect_row *const r = &row[rows++];
        *r = (struct effect_row){.effect = e,
                                 .named = named,
                                 .instead = named ? NULL : stand_in(s, e),
                                 .time = effects_time_of(e, in, k->rho_f > 0.0),
                                 .estimate = {.share = NAN}};
        k->numbers = named ? numbers : NULL;
        k->pair = named ? effects_pair_of(e, numbers, all, n) : NULL;
        if (e->estimate != NULL) r->estimate = e->estimate(k);
        tell_of_net(e, k, &r->estimate);
        r->refused = case_clumps_refuse(s, e->keys[0]->path);
    }
    free(all);
    return rows;
}

/* What would tell of an effect that is unknown: a run of some relaxation times.
 * Charges and moisture only the user knows. */
static void print_what_tells(const struct settings *s,
                             const struct effect_scales *k)
{
    const double times = 5.0 * k->tau, steps = 20.0 * k->dt;

    printf(
        "  a run that tells of the unknown ones: winnow check %s --try %.2g\n",
        s->file, fmin(fmax(times, steps), k->end));
}

/* 1 if a run would tell of one of them. */
static int print_effects(const struct settings *s, struct effect_scales *k,
                         const struct case_scales *in)
{
    struct effect_row row[CHECK_EFFECTS];
    const int n = check_effect_rows(s, k, in, row);
    int tries = 0;

    for (int i = 0; i < n; i++) {
        const struct effect_row *const r = &row[i];
        char verdict[CHECK_VERDICT];

        check_verdict(r, verdict);
        print_row(r->effect->name, &r->estimate, 100.0 * r->time, r->named,
                  verdict);
        tries |= strncmp(verdict, "unknown", 7) == 0 &&
                 r->effect->attraction == NULL && !r->refused;
    }
    return tries;
}

/* What the particles give to the fluid, of the momentum of both: the ways of
 * Elghobashi's map, from the load where they are. A lone one would feel its own
 * wake. */
static void print_reaction(const struct settings *s,
                           const struct effect_scales *k)
{
    const double M = stability_loading(k->rho_s, k->eps_s, k->rho_f);
    struct effect_estimate e = effects_estimate(M / (1.0 + M), "");
    char verdict[CHECK_VERDICT];

    snprintf(e.remark, sizeof e.remark, "solids %.2g of the volume, load %.3g",
             k->eps_s, M);
    if (!k->partners) {
        e.loss = 0.0;
        snprintf(e.remark, sizeof e.remark,
                 "a lone grain would only meet its own wake");
    }
    e.of = "the momentum of the mixture";
    check_verdict(&(struct effect_row){.estimate = e}, verdict);
    print_row("reaction (two-way)", &e, NAN, s->exchange.two_way, verdict);
}

/* Contacts with each other in the time of the run, or with a floor. */
static void print_collisions(const struct settings *s,
                             const struct effect_scales *k, double end)
{
    const double rate = k->meetings;
    const int often = k->rests || rate * end > noticed;
    char verdict[CHECK_VERDICT];

    if (s->effects.particle_stress)
        snprintf(verdict, sizeof verdict,
                 "negligible: particle_stress stands for them");
    else if (k->rests && k->tau == 0.0)
        snprintf(verdict, sizeof verdict, "needed: they lie on each other");
    else if (k->rests)
        snprintf(verdict, sizeof verdict,
                 "needed: they lie on each other; the drag slows one in %.2g s",
                 k->tau);
    else if (often)
        snprintf(
            verdict, sizeof verdict,
            "needed: one in %.2g s for a grain, the drag slows it in %.2g s",
            1.0 / rate, k->tau);
    else if (s->effects.has_gravity || k->slip > 0.0)
        snprintf(verdict, sizeof verdict,
                 "negligible: hardly one with a grain in %.3g s; with a floor "
                 "or a wall if it comes there",
                 end);
    else
        snprintf(verdict, sizeof verdict, "negligible: nothing moves");
    print_row("collisions", &(struct effect_estimate){.share = NAN}, NAN,
              !s->particles.list->no_contacts, verdict);
}

void check_effects(const struct settings *s, const struct case_scales *in)
{
    struct effect_scales k = check_scales(s, in);

    if (!(k.force > 0.0)) return;
    print_head();
    const int tries = print_effects(s, &k, in);
    if (!s->has.exchange) return;
    print_reaction(s, &k);
    print_collisions(s, &k, in->end);
    if (tries) print_what_tells(s, &k);
}
