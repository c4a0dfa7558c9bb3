/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/effect_shares.h"

#include <stdio.h>

double effect_shares_mean(const struct simulation *sim, int i)
{
    const double scale = sim->force_scale.sum;
    return scale > 0.0 ? sim->effects[i].tally.sum / scale : 0.0;
}

double effect_shares_largest(const struct simulation *sim, int i)
{
    const struct effect_tally *const scale = &sim->force_scale;
    return scale->sum > 0.0
               ? sim->effects[i].tally.largest / (scale->sum / (double)scale->n)
               : 0.0;
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
