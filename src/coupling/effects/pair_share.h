/* pair_share.h -- measures a force between close particles.
 * Chapter "Further forces".
 *
 * The loops of the particles add up the forces of all laws. For the report of
 * an effect, the force of its law alone is computed again after every eighth
 * step: for each particle the strongest one of all partners and walls.
 */
#ifndef COUPLING_EFFECTS_PAIR_SHARE_H
#define COUPLING_EFFECTS_PAIR_SHARE_H

#include "coupling/simulation.h"
#include "dem/attraction.h"

/* The memory of an effect with this law; NULL if the particles do not have
 * it. */
void *pair_share_create(struct simulation *sim,
                        const struct attraction_law *law);
void pair_share_free(void *memory);

/* The hook after a step. */
void pair_share_after_step(void *memory, struct simulation *sim);

#endif
