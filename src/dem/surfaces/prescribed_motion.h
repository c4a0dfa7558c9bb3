/* prescribed_motion.h -- prescribed motion of surfaces and particles, for the
 * chunks of this thread.
 * Chapter "Walls".
 */
#ifndef DEM_SURFACES_PRESCRIBED_MOTION_H
#define DEM_SURFACES_PRESCRIBED_MOTION_H

#include "dem/fast/neighbours.h"

/* Puts the surfaces where they are at time t [s]. */
void prescribed_motion_move_surfaces(const struct neighbours *nb, double t);

/* Makes the prescribed particles ready for a drift of dt from there [s]. */
void prescribed_motion_set_velocities(const struct neighbours *nb, double t,
                                      double dt);

#endif
