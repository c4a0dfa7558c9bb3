/* pair_share.h -- measures a force between close particles.
 * Chapter "Further forces".
 *
 * The loops of the particles add all forces of pairs up and do not tell them
 * apart. For the report of what an effect has done, the force of one law is
 * computed again after every eighth step: of each particle the
 * strongest one, of partners and walls.
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
