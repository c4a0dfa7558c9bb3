/* lubrication.h -- the liquid between two particles that are close.
 * Chapter "Further forces".
 *
 *   F = 6 pi mu R*^2 (1/z - 1/z_out) dz/dt,   R* = R_i R_j/(R_i + R_j)  [Cox67]
 *
 * against the change of the gap z, along the line of centres, for z < z_out;
 * R* = R at a wall. With the last term it begins at zero; at larger gaps it is
 * part of the drag. Below z_min, the height of the roughness, the gap counts as
 * z_min; for surfaces in contact the contact law has the damping. There is no
 * force on the liquid: the forces on the two are opposite.
 */
#ifndef COUPLING_EFFECTS_LUBRICATION_H
#define COUPLING_EFFECTS_LUBRICATION_H

/* The coefficient [kg/s] for a gap z [m] of 0 or more. */
double lubrication_coefficient(double mu, double R_star, double z, double z_min,
                               double z_out);

#endif
