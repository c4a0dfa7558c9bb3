/* replacement.h -- insertion and removal of particles in a coupled run.
 * Chapter "The coupled loop".
 *
 * An inserted particle replaces the same volume of fluid, and fluid replaces a
 * removed particle, immediately and in the same cells: this causes no flow and
 * no change of pressure. (If the fluid had to flow out of the way within one
 * step instead, a grain would cause a jet, and in a closed box there would be
 * no solution.) The unpaid impulse of a removed particle acts on the fluid in
 * the next step, in the cells where the particle was. Therefore
 *
 *   momentum of fluid and particles - unpaid - (inserted - removed)
 *
 * is conserved as in a run without insertion and removal.
 */
#ifndef COUPLING_REPLACEMENT_H
#define COUPLING_REPLACEMENT_H

#include "coupling/simulation.h"

/* Removes and inserts particles before a step, by sim->population. With
 * coupling, the averaged fields and the drag terms are then those of the new
 * particles. Non-zero as the next one. */
int replacement_step(struct simulation *sim);

/* After particles were removed, or inserted from index `first` on: averages
 * anew, replaces the fluid, and makes the drag terms of the next step. Non-zero
 * if the solid volume of a cell exceeds its volume. */
int replacement_apply(struct simulation *sim, int first);

/* Momentum of inserted minus that of removed particles since the run began,
 * including the fluid that they replaced [N s]. */
void replacement_momentum(const struct simulation *sim, double brought[3]);

#endif
