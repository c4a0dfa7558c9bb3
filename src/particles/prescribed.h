/* prescribed.h -- what moves as prescribed, in this thread's share. Chapter 14.
 */
#ifndef PRESCRIBED_H
#define PRESCRIBED_H

#include "particles/neighbours.h"

/* Puts the surfaces where they are at time t [s]. */
void prescribed_move(const struct neighbours *nb, double t);

/* Makes the driven particles ready for a drift of dt from there [s]. */
void prescribed_steer(const struct neighbours *nb, double t, double dt);

#endif
