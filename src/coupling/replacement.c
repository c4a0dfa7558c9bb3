/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/replacement.h"
#include "coupling/transfer.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/coupling.h"
#include "dem/population/population.h"
#include "fluid/piso.h"

/* Of the first particles that are inserted or removed. */
static void replacement_create(struct coupling *cp, int n_cells)
{
    struct replacement *const r = owner_zeroed(
        cp, 1, sizeof *r + 4 * (size_t)n_cells * sizeof *r->eps_before);

    r->eps_before = (double *)(r + 1);
    r->unpaid_impulse = r->eps_before + n_cells;
    cp->replacement = r;
}

/* Before the marked particles are removed: stores their unpaid impulse. */
static void collect_unpaid(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;
    double *const impulse = cp->smooth; /* not in use between two steps */

    if (!cp->options.two_way) return;
    if (cp->replacement == NULL) replacement_create(cp, sim->mesh->n_cells);
    struct replacement *const r = cp->replacement;
    for (int i = 0; i < sim->particles->n; i++)
        for (int k = 0; k < 3; k++) {
            const int j = 3 * i + k;
            impulse[j] =
                sim->population->is_removed[i] ? cp->unpaid_impulse[j] : 0.0;
            r->unpaid_sum[k] += impulse[j];
        }
    averaging_spread(sim->averaging, 3, impulse, r->unpaid_impulse);
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

/* Particles were put into the fluid or taken out of it at rest: eps has changed
 * from eps_before by that alone. Particles and fluid replace each other in
 * place, so that there is no flow: the old values of eps change as well, and
 * the displaced fluid is removed with its velocity. Returns the lowest old eps
 * [-]: not above 0 if the inserted solid volume exceeds the fluid volume.
 *
 * The displaced momentum is rho eps u of the latest time level and, in a
 * two-step scheme, what is pending of its gain since the level before. */
static double replace_fluid(struct fluid *fl, const double *eps_before)
{
    const int gains = fl->u_older != NULL && fl->dt_older > 0.0;
    double lowest = 1.0;

    for (int c = 0; c < fl->mesh->n_cells; c++) {
        const double change = fl->eps[c] - eps_before[c];
        const double mass =
            fl->options.rho * fl->mesh->V[c] * change; /* [kg] */
        fl->eps_n[c] += change;
        fl->eps_nm1[c] += change;
        lowest = fmin(lowest, fmin(fl->eps_n[c], fl->eps_nm1[c]));
        fl->replaced -= mass;
        for (int k = 0; k < 3; k++) {
            const double u = fl->u[3 * c + k];
            const double gained =
                gains ? mass * (u - fl->u_older[3 * c + k]) : 0.0;
            fl->replaced_momentum[k] -= mass * u + ddt_pending(fl) * gained;
            fl->momentum_gained[k] += gained;
        }
    }
    return lowest;
}

int replacement_apply(struct simulation *sim, int first)
{
    const int n_cells = sim->mesh->n_cells;
    struct coupling *const cp = sim->coupling;

    if (cp->replacement == NULL) replacement_create(cp, n_cells);
    double *const eps_before = cp->replacement->eps_before;
    transfer_start_velocity(sim, first);
    memcpy(eps_before, sim->fluid->eps, (size_t)n_cells * sizeof *eps_before);
    if (transfer_average(sim) != 0) return 1;
    if (cp->options.two_way) {
        cp->report.eps_lowest =
            fmin(cp->report.eps_lowest, replace_fluid(sim->fluid, eps_before));
        if (cp->report.eps_lowest <= 0.0) return 1;
    }
    start_fluid_velocity(sim, first);
    transfer_drag_terms(sim);
    return 0;
}

void replacement_momentum(const struct simulation *sim, double brought[3])
{
    const struct population_totals *const a = &sim->population->totals;

    for (int k = 0; k < 3; k++) {
        brought[k] = a->momentum_in[k] - a->momentum_out[k];
        if (sim->fluid != NULL) brought[k] -= sim->fluid->replaced_momentum[k];
    }
}

int replacement_step(struct simulation *sim)
{
    struct particles *const ps = sim->particles;
    struct population *const population = sim->population;
    const int removed = population_mark(population, ps, sim->dt);

    if (sim->coupling != NULL && removed > 0) collect_unpaid(sim);
    if (removed > 0) dem_remove(sim->dem, population->is_removed);
    const int first = population_insert(population, ps, sim->dem, sim->t);
    if (sim->coupling == NULL || (removed == 0 && first == ps->n)) return 0;
    return replacement_apply(sim, first);
}
