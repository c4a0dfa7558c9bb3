/* pcm.h -- the particle-centroid method: the cell takes what is in it.
 * Chapter 8.
 *
 *     eps_s,c = (1 / V_c) sum of the V_p of the particles whose centre is in c
 *                                                   [XS11 3.1, SX15 4, 7, 8]
 *
 * With a cap the share s_c = min(1, cap / eps_s,c) of every particle in c is
 * spread, whatever the amount: volume, momentum, force. Thus eps_s <= cap, and
 * the mean velocity of a cell (momentum over volume) is what it was. Gathering
 * takes the same share, s_c f_c, and so stays the adjoint; it does not give a
 * constant back in a capped cell (the interpolations all do). What the cap
 * takes away is lost to the fields: the report says in how many cells and how
 * much volume.
 */
#ifndef PCM_H
#define PCM_H

#include "averaging/averaging_method.h"

extern const struct averaging_method pcm_method;

#endif
