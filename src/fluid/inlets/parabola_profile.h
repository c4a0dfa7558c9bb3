/* parabola_profile.h -- the velocity of a laminar flow between two walls. */
#ifndef FLUID_INLETS_PARABOLA_PROFILE_H
#define FLUID_INLETS_PARABOLA_PROFILE_H

/* Mean of a parabolic profile, zero at both ends of a channel 0 .. 1, over the
 * interval a .. b, divided by its mean over the channel [-]. */
double parabola_profile_mean(double a, double b);

#endif
