/* effect_shares.h -- what the effects of a run have done.
 * Chapter "Further forces".
 *
 * The share of an effect is the mean size of its force over the mean of what
 * `winnow check` compares it with: the larger one of weight and drag of each
 * particle (coupling/effects.h).
 */
#ifndef CASE_EFFECT_SHARES_H
#define CASE_EFFECT_SHARES_H

#include "coupling/simulation.h"
#include "output/summary.h"

/* Mean share of effect i [-]; 0 if it has no force. And the largest, of one
 * particle over the mean. */
double effect_shares_mean(const struct simulation *sim, int i);
double effect_shares_largest(const struct simulation *sim, int i);

/* Two groups of the summary, a name and a number or group each. */
void effect_shares_write(struct summary *f, const struct simulation *sim);

/* A line each on stdout. */
void effect_shares_print(const struct simulation *sim);

#endif
