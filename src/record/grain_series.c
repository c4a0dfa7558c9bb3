/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "record/grain_series.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "coupling/coupling.h"
#include "coupling/drag_laws/coefficient.h"

struct grain_series *grain_series_create(int capacity, int rows)
{
    struct grain_series *const g = alloc_zeroed(1, sizeof *g);

    g->capacity = capacity;
    g->rows = rows;
    g->Cd = alloc_doubles(capacity * rows);
    g->Re = alloc_doubles(capacity);
    g->eps = alloc_doubles(capacity);
    return g;
}

void grain_series_free(struct grain_series *g)
{
    if (g == NULL) return;
    free(g->Cd);
    free(g->Re);
    free(g->eps);
    free(g);
}

static double grain_series_slip_of(const struct simulation *sim, int i)
{
    const struct particles *const ps = sim->particles;
    const double *const u = &sim->coupling->u_f[3 * i];

    return gsl_hypot3(u[0] - ps->vx[i], u[1] - ps->vy[i], u[2] - ps->vz[i]);
}

/* 1 if the particles are 0 .. n - 1, n of them. */
static int are_the_first(const struct particles *ps, int n)
{
    int highest = -1;

    for (int i = 0; i < ps->n; i++)
        highest = ps->id[i] > highest ? ps->id[i] : highest;
    return ps->n == n && highest == n - 1;
}

void grain_series_add(struct grain_series *g, const struct simulation *sim)
{
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;
    const struct coupling *const cp = sim->coupling;

    if (g->n_rows == 0) g->n = ps->n;
    g->changed = g->changed || !are_the_first(ps, g->n);
    if (g->changed || ps->n == 0) return;
    for (int i = 0; i < ps->n; i++) {
        const int id = ps->id[i];
        const double w = grain_series_slip_of(sim, i), eps = cp->eps[i],
                     d = ps->d[i];
        g->eps[id] = eps;
        g->Re[id] = coefficient_reynolds(eps, o->rho, o->mu, d, w);
        g->Cd[(long)id * g->rows + g->n_rows] =
            w > 0.0
                ? coefficient_of_force(cp->rate[i] * w / eps, o->rho, d, eps, w)
                : 0.0;
    }
    g->n_rows++;
}

void grain_series_state(struct grain_series *g, struct state *s)
{
    state_count(s, "grain_rows", &g->n_rows, g->rows);
    state_count(s, "grains", &g->n, g->capacity);
    state_whole(s, "changed", "-", &g->changed);
    if (g->n_rows > 0)
        state_reals_of(s, "C_d", "-", g->Cd, (size_t)g->rows * sizeof *g->Cd,
                       g->n, g->n_rows);
    state_reals(s, "Re_p", "-", g->Re, g->n, 1);
    state_reals(s, "eps_f", "-", g->eps, g->n, 1);
}
