/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/processes.h"

void processes_join(const struct simulation *sim, enum processes_order order)
{
    if (sim->processes != NULL) sim->processes->join(sim->processes, order);
}

void processes_sum(const struct simulation *sim, int n, double *x)
{
    if (sim->processes != NULL) sim->processes->sum(sim->processes, n, x);
}

double processes_total(const struct simulation *sim, double x)
{
    processes_sum(sim, 1, &x);
    return x;
}

/* The largest x of all processes, or x where there is one. */
int processes_largest(const struct simulation *sim, int x)
{
    return sim->processes == NULL ? x
                                  : sim->processes->largest(sim->processes, x);
}

double processes_cells(const struct simulation *sim)
{
    return sim->processes != NULL ? sim->processes->cells : sim->mesh->n_cells;
}

double processes_particles(const struct simulation *sim)
{
    return sim->particles == NULL   ? 0.0
           : sim->processes != NULL ? sim->processes->particles
                                    : sim->particles->n;
}
