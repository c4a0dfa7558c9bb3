/* pcm.h -- the particle-centroid method: the cell takes what is in it.
 * Chapter 8.
 *
 *     eps_s,c = (1 / V_c) sum of the V_p of the particles whose centre is in c
 *                                                   [XS11 3.1, SX15 4, 7, 8]
 *
 * With a cap the fluid makes room for the share s_c = min(1, cap / eps_s,c) of
 * every particle in c. Spreading and gathering do as without: the caller cuts
 * the volumes (averaging_leave_out), and with them all that goes by volume, but
 * not the drag, which the fluid must get back whole. Thus eps_s <= cap, and the
 * mean velocity of a cell (momentum over volume) is what it was. What the cap
 * leaves out is lost to eps_s: the report says in how many cells and how much.
 */
#ifndef PCM_H
#define PCM_H

#include "averaging/averaging_method.h"

extern const struct averaging_method pcm_method;

#endif
