/* pcm.h -- the particle-centroid method: a particle counts wholly in the cell
 * of its centre.
 * Chapter "Averaging".
 *
 *     eps_s,c = (1 / V_c) sum of the V_p of the particles whose centre is in c
 *                                                   [XS11 3.1, SX15 4, 7, 8]
 *
 * With a cap only the fraction s_c = min(1, cap / eps_s,c) of the volume of
 * every particle in c is used. Spreading and gathering are unchanged: the
 * caller reduces the volumes (averaging_apply_cap) and all amounts proportional
 * to volume, but not the drag, whose reaction must act on the fluid completely.
 * Thus eps_s <= cap, and the mean velocity of a cell (momentum over volume) is
 * unchanged. The volume above the cap is missing in eps_s: the report gives the
 * number of cells and the volume.
 */
#ifndef AVERAGING_PCM_H
#define AVERAGING_PCM_H

#include "averaging/averaging_method.h"

extern const struct averaging_method pcm_method;

#endif
