/* capillary.h -- the force of a capillary bridge.
 * Chapter "Materials, rolling and cohesion".
 *
 *   F = -2 pi R* gamma cos theta                                [LS 4.15]
 *
 * gamma is the surface tension, theta the angle of contact. The force of a
 * bridge of little liquid does not depend on the gap, and ends where the gap
 * exceeds the range, in LS as soon as the spheres separate.
 *
 * LS takes the mean of the radii for R*, which is right for equal spheres. For
 * unequal ones Derjaguin's geometry gives the harmonic mean 2 R_i R_j/(R_i +
 * R_j); the mean would make the bridge between a grain and a boulder as strong
 * as the boulder is large. For a wall it has no value, so there we always take
 * the harmonic one, 2 R: F = -4 pi R gamma cos theta.
 */
#ifndef DEM_COHESION_CAPILLARY_H
#define DEM_COHESION_CAPILLARY_H

#include "dem/attraction.h"

extern const struct attraction_law capillary;

/* [m] R*: the mean of the radii [LS 4.15], and Derjaguin's. */
double capillary_mean(double R_i, double R_j);
double capillary_harmonic_mean(double R_i, double R_j);

/* [N] negative: it pulls; tension = gamma cos theta [N/m]. */
double capillary_force(double tension, double R_star);

#endif
