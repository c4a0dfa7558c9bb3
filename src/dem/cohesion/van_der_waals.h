/* van_der_waals.h -- van der Waals' attraction.
 * Chapter "Materials, rolling and cohesion".
 *
 *   F = A / (12 l^2) D_i D_j / (D_i + D_j)                      [LS 4.14]
 *
 * is the attraction of two spheres with a gap l between their surfaces, for l
 * much smaller than the spheres; A is Hamaker's constant. LS calls l the
 * separation at which the particles start to interact, and prints no sign: it
 * is the gap, and the force is an attraction. For l to 0 the formula has no
 * limit. Below `closest`, the distance of molecules that touch, the force stays
 * what it is there, also where the spheres overlap. A wall is a sphere without
 * end: D_i D_j / (D_i + D_j) becomes D_i.
 */
#ifndef DEM_COHESION_VAN_DER_WAALS_H
#define DEM_COHESION_VAN_DER_WAALS_H

#include "dem/attraction.h"

extern const struct attraction_law van_der_waals;

/* [m] D_i D_j / (D_i + D_j). */
double van_der_waals_diameter(double D_i, double D_j);

/* [N] of attraction; A [J], D_star [m], l [m]. */
double van_der_waals_force(double A, double D_star, double l);

#endif
