/* history_energy.h -- the energy budget of the particles, column by column. */
#ifndef HISTORY_ENERGY_H
#define HISTORY_ENERGY_H

#include "exchange/simulation.h"

/* All in J; what they mean stands in particles/energy.h. The budget must be
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

#endif
