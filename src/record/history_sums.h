/* history_sums.h -- numbers of the whole bed: sums over particles and faces
 * that columns of the history and means of a run are made of.
 */
#ifndef RECORD_HISTORY_SUMS_H
#define RECORD_HISTORY_SUMS_H

#include "coupling/simulation.h"

/* Mean pressure where the fluid enters less that where it leaves [Pa]; between
 * bottom and top where there is no inlet. */
double history_pressure_drop(const struct simulation *sim);

/* Weight of the particles over the cross-section of the box normal to gravity
 * [Pa]; 0 without gravity. */
double history_bed_weight(const struct simulation *sim);

/* The same less the weight of the fluid in their place [Pa]. */
double history_buoyant_weight(const struct simulation *sim);

/* Kinetic energy of the particles, and that of their rotation [J]. */
double history_particle_energy(const struct simulation *sim);
double history_spin_energy(const struct simulation *sim);

/* A third of the mean square of their velocity about its mean [m^2/s^2]. */
double history_granular_temperature(const struct simulation *sim);

/* Mean height of the particles, the coordinate against gravity [m]; without
 * gravity that of y. */
double history_mean_height(const struct simulation *sim);

/* Mean of their velocity along gravity [m/s]; 0 without gravity. */
double history_mean_fall(const struct simulation *sim);

#endif
