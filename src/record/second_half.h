/* second_half.h -- means over the second half of a run, for its summary, and
 * what makes such a mean meaningless.  Chapter "Output".
 *
 * The mean over a few bubbles has a large statistical error, and that of a bed
 * whose bubbles stay on one side, or that moves up and down as a whole, does
 * not describe bubbling. The summary therefore has, besides the mean pressure
 * drop and the weight of the bed,
 *
 *   mean_pressure_drop_error   the error of the first by blocks [Pa]
 *   particle_velocity_rms      over particles and time [m/s]
 *   horizontal_velocity_rms    of the bed as a whole: its momentum normal to
 *                              gravity over its mass [m/s]
 *   vertical_velocity_rms      the same along gravity: plane pumping [m/s]
 *   lean, lean_error           how far its centre is off the middle along x,
 *                              over half the width [-], and the error by blocks
 */
#ifndef RECORD_SECOND_HALF_H
#define RECORD_SECOND_HALF_H

#include "coupling/simulation.h"

struct second_half;

/* Of a run to `end` [s]. The simulation is borrowed. */
struct second_half *second_half_create(const struct simulation *sim,
                                       double end);
void second_half_free(struct second_half *h);

/* Takes a sample, if there is a fluid; several processes do it together. */
void second_half_add(struct second_half *h);

#endif
