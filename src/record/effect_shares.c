/* SPDX-License-Identifier: GPL-3.0-or-later */
/* effect_shares.c -- what the effects of a run have done.
 * Chapter "Further forces".
 *
 * The share of an effect is the mean size of its force over the mean of what
 * `winnow check` compares it with: the largest of weight, drag and push on each
 * particle (coupling/effects.h).
 */
#include "record/recorder_part.h"

#include <stdio.h>

/* [N] */
static double effect_shares_mean(const struct effect_tally *t)
{
    return t->weight > 0.0 ? t->sum / t->weight : 0.0;
}

static double over_scale(const struct simulation *sim, double force)
{
    return effect_shares_mean(&sim->force_scale) > 0.0
               ? force / effect_shares_mean(&sim->force_scale)
               : 0.0;
}

/* Mean share of effect i [-]; 0 if it has no force. */
static double mean_share(const struct simulation *sim, int i)
{
    return over_scale(sim, effect_shares_mean(&sim->effects[i].tally));
}

/* The largest force on one particle over the mean scale [-]. */
static double largest_share(const struct simulation *sim, int i)
{
    return over_scale(sim, sim->effects[i].tally.largest);
}

/* Nothing but the simulation. */
static void *effect_shares_create(const struct recorder_view *v, int *failed)
{
    (void)failed;
    return v->sim->n_effects > 0 ? (void *)v->sim : NULL;
}

static void effect_shares_summarize(const void *part, struct summary *f)
{
    const struct simulation *const sim = part;

    summary_begin(f, "effects");
    for (int i = 0; i < sim->n_effects; i++) {
        summary_begin(f, sim->effects[i].effect->name);
        summary_number(f, "mean_share", mean_share(sim, i));
        summary_number(f, "largest_share", largest_share(sim, i));
        summary_end(f);
    }
    summary_end(f);
    summary_begin(f, "effect_seconds");
    for (int i = 0; i < sim->n_effects; i++)
        summary_number(f, sim->effects[i].effect->name,
                       sim->effects[i].tally.seconds);
    summary_end(f);
}

/* In words that a large share can be read in: 4.3 %, 100 %, 71 times it. */
static void share_text(double share, char text[32])
{
    snprintf(text, 32,
             share < 0.995  ? "%.2g %%"
             : share < 10.0 ? "%.0f %%"
                            : "%.0f times it",
             share < 10.0 ? 100.0 * share : share);
}

static void effect_shares_print(const void *part)
{
    const struct simulation *const sim = part;

    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        if (e->tally.sum == 0.0) continue;
        char mean_text[32], largest_text[32];
        share_text(mean_share(sim, i), mean_text);
        share_text(largest_share(sim, i), largest_text);
        printf("%s %s of weight or drag, at most %s, ", e->effect->name,
               mean_text, largest_text);
        printf(e->tally.seconds < 0.95 ? "in less than a second\n"
                                       : "in %.2g s\n",
               e->tally.seconds);
    }
}

const struct recorder_part recorder_effect_shares = {
    .create = effect_shares_create,
    .summarize = effect_shares_summarize,
    .print = effect_shares_print};
