/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/history_energy.h"

#include "coupling/replacement.h"
#include "dem/energy.h"
#include "dem/population.h"

double history_energy_normal(const struct simulation *sim)
{
    return dem_energy(sim->dem)->normal;
}

double history_energy_tangential(const struct simulation *sim)
{
    return dem_energy(sim->dem)->tangential;
}

double history_energy_damped_n(const struct simulation *sim)
{
    return dem_energy(sim->dem)->damped_n;
}

double history_energy_damped_t(const struct simulation *sim)
{
    return dem_energy(sim->dem)->damped_t;
}

double history_energy_slid(const struct simulation *sim)
{
    return dem_energy(sim->dem)->slid;
}

double history_energy_released(const struct simulation *sim)
{
    return dem_energy(sim->dem)->released;
}

double history_energy_rolled(const struct simulation *sim)
{
    return dem_energy(sim->dem)->rolled;
}

double history_energy_work(const struct simulation *sim)
{
    return dem_energy(sim->dem)->work;
}

double history_energy_attracted(const struct simulation *sim)
{
    return dem_energy(sim->dem)->attracted;
}

double history_energy_walls(const struct simulation *sim)
{
    return dem_energy(sim->dem)->walls;
}

double history_energy_brought(const struct simulation *sim)
{
    return dem_energy(sim->dem)->added;
}

double history_energy_residual(const struct simulation *sim)
{
    return energy_residual(dem_energy(sim->dem));
}

double history_particles(const struct simulation *sim)
{
    return sim->particles->n;
}

double history_inserted(const struct simulation *sim)
{
    return (double)sim->population->totals.inserted;
}

double history_removed(const struct simulation *sim)
{
    return (double)sim->population->totals.removed;
}

double history_waiting(const struct simulation *sim)
{
    return (double)sim->population->totals.waiting;
}

double history_mass_in(const struct simulation *sim)
{
    return sim->population->totals.mass_in;
}

double history_mass_out(const struct simulation *sim)
{
    return sim->population->totals.mass_out;
}

static double brought(const struct simulation *sim, int k)
{
    double sum[3];

    replacement_momentum(sim, sum);
    return sum[k];
}

double history_brought_x(const struct simulation *sim)
{
    return brought(sim, 0);
}

double history_brought_y(const struct simulation *sim)
{
    return brought(sim, 1);
}

double history_brought_z(const struct simulation *sim)
{
    return brought(sim, 2);
}

double history_replaced(const struct simulation *sim)
{
    return sim->fluid->replaced;
}
