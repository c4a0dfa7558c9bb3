/* electrostatic.h -- the force between charged spheres.
 * Chapter "Materials, rolling and cohesion".
 *
 *   F = q_i q_j / (4 pi eps_0 eps_r l^2)                        [LS 4.13]
 *
 * l is the distance of the centres; like signs repel. Each sphere of a material
 * has that material's charge. Walls have none, and the force ends at the range.
 */
#ifndef DEM_COHESION_ELECTROSTATIC_H
#define DEM_COHESION_ELECTROSTATIC_H

#include "dem/attraction.h"

extern const struct attraction_law electrostatic;

/* [N] q [C], l [m], eps_r [-]; positive pushes apart. */
double electrostatic_force(double q_i, double q_j, double eps_r, double l);

#endif
