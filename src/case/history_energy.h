/* history_energy.h -- columns of the particles: their energy budget, and how
 * many are inserted and removed. */
#ifndef CASE_HISTORY_ENERGY_H
#define CASE_HISTORY_ENERGY_H

#include "coupling/simulation.h"

/* All in J; what they mean stands in dem/energy.h. The budget must be
 * kept. */
double history_energy_normal(const struct simulation *sim);
double history_energy_tangential(const struct simulation *sim);
double history_energy_damped_n(const struct simulation *sim);
double history_energy_damped_t(const struct simulation *sim);
double history_energy_slid(const struct simulation *sim);
double history_energy_released(const struct simulation *sim);
double history_energy_rolled(const struct simulation *sim);
double history_energy_work(const struct simulation *sim);
double history_energy_attracted(const struct simulation *sim);
double history_energy_walls(const struct simulation *sim);
double history_energy_brought(const struct simulation *sim);
double history_energy_residual(const struct simulation *sim);

/* For a simulation with a population (dem/population.h). Masses in kg. */
double history_particles(const struct simulation *sim);
double history_inserted(const struct simulation *sim);
double history_removed(const struct simulation *sim);
double history_waiting(const struct simulation *sim);
double history_mass_in(const struct simulation *sim);
double history_mass_out(const struct simulation *sim);
/* Momentum of the inserted particles and of the fluid that they replaced, less
 * that of the removed ones [N s]; and the mass of that fluid [kg], which needs
 * a coupling. */
double history_brought_x(const struct simulation *sim);
double history_brought_y(const struct simulation *sim);
double history_brought_z(const struct simulation *sim);
double history_replaced(const struct simulation *sim);

#endif
