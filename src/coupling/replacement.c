/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/replacement.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/coupling.h"
#include "coupling/transfer.h"
#include "dem/population.h"

struct replacement *replacement_create(int n_cells)
{
    struct replacement *const r = alloc_zeroed(1, sizeof *r);

    r->eps_before = alloc_doubles(n_cells);
    r->unpaid_impulse = alloc_doubles(3 * n_cells);
    return r;
}

void replacement_free(struct replacement *r)
{
    if (r == NULL) return;
    free(r->eps_before);
    free(r->unpaid_impulse);
    free(r);
}

void replacement_collect_unpaid(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;
    struct replacement *const r = cp->replacement;
    double *const impulse = cp->smooth; /* not in use between two steps */

    if (!cp->options.two_way) return;
    for (int i = 0; i < sim->particles->n; i++)
        for (int k = 0; k < 3; k++) {
            const int j = 3 * i + k;
            impulse[j] =
                sim->population->is_removed[i] ? cp->unpaid_impulse[j] : 0.0;
            r->unpaid_sum[k] += impulse[j];
        }
    averaging_spread(sim->averaging, 3, impulse, r->unpaid_impulse);
}

/* The mean velocity of an inserted particle is its own initial velocity. */
static void start_velocity(struct simulation *sim, int first)
{
    const struct particles *const ps = sim->particles;

    for (int i = first; i < ps->n; i++) {
        double *const u_mean = &sim->coupling->u_mean[3 * i];
        u_mean[0] = ps->vx[i];
        u_mean[1] = ps->vy[i];
        u_mean[2] = ps->vz[i];
    }
}

/* The first drag of an inserted particle needs the fluid velocity there. */
static void start_fluid_velocity(struct simulation *sim, int first)
{
    struct coupling *const cp = sim->coupling;
    const size_t n = (size_t)(sim->particles->n - first);

    if (n == 0) return;
    transfer_velocity(sim, cp->smooth);
    memcpy(&cp->u_f[3 * first], &cp->smooth[3 * first],
           3 * n * sizeof *cp->u_f);
}

int replacement_apply(struct simulation *sim, int first)
{
    const int n_cells = sim->mesh->n_cells;
    struct coupling *const cp = sim->coupling;
    double *const eps_before = cp->replacement->eps_before;

    start_velocity(sim, first);
    memcpy(eps_before, sim->fluid->eps, (size_t)n_cells * sizeof *eps_before);
    if (transfer_average(sim) != 0) return 1;
    if (cp->options.two_way) {
        cp->report.eps_lowest =
            fmin(cp->report.eps_lowest, fluid_replace(sim->fluid, eps_before));
        if (cp->report.eps_lowest <= 0.0) return 1;
    }
    start_fluid_velocity(sim, first);
    transfer_drag_terms(sim);
    return 0;
}

void replacement_add_force(const struct replacement *r, int n_cells, double dt,
                           double *field)
{
    if (r == NULL) return;
    for (int c = 0; c < n_cells; c++)
        for (int k = 0; k < 3; k++)
            field[4 * c + 1 + k] -= r->unpaid_impulse[3 * c + k] / dt;
}

void replacement_reset(struct replacement *r, int n_cells)
{
    if (r == NULL) return;
    memset(r->unpaid_impulse, 0,
           3 * (size_t)n_cells * sizeof *r->unpaid_impulse);
    memset(r->unpaid_sum, 0, sizeof r->unpaid_sum);
}

void replacement_momentum(const struct simulation *sim, double brought[3])
{
    const struct population_totals *const a = &sim->population->totals;

    for (int k = 0; k < 3; k++) {
        brought[k] = a->momentum_in[k] - a->momentum_out[k];
        if (sim->fluid != NULL) brought[k] -= sim->fluid->replaced_momentum[k];
    }
}
