/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/effect_shares.h"

#include <stdio.h>

/* [N] */
static double mean(const struct effect_tally *t)
{
    return t->weight > 0.0 ? t->sum / t->weight : 0.0;
}

static double over_scale(const struct simulation *sim, double force)
{
    return mean(&sim->force_scale) > 0.0 ? force / mean(&sim->force_scale)
                                         : 0.0;
}

double effect_shares_mean(const struct simulation *sim, int i)
{
    return over_scale(sim, mean(&sim->effects[i].tally));
}

double effect_shares_largest(const struct simulation *sim, int i)
{
    return over_scale(sim, sim->effects[i].tally.largest);
}

void effect_shares_write(struct summary *f, const struct simulation *sim)
{
    if (sim->n_effects == 0) return;
    summary_begin(f, "effects");
    for (int i = 0; i < sim->n_effects; i++) {
        summary_begin(f, sim->effects[i].effect->name);
        summary_number(f, "mean_share", effect_shares_mean(sim, i));
        summary_number(f, "largest_share", effect_shares_largest(sim, i));
        summary_end(f);
    }
    summary_end(f);
    summary_begin(f, "effect_seconds");
    for (int i = 0; i < sim->n_effects; i++)
        summary_number(f, sim->effects[i].effect->name,
                       sim->effects[i].tally.seconds);
    summary_end(f);
}

void effect_shares_print(const struct simulation *sim)
{
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        if (e->tally.sum == 0.0) continue;
        printf("%s %.2g %% of weight or drag, at most %.2g %%, in %.0f s\n",
               e->effect->name, 100.0 * effect_shares_mean(sim, i),
               100.0 * effect_shares_largest(sim, i), e->tally.seconds);
    }
}
