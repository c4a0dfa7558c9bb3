/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "distributed/ranks/smoothing.h"

#include <gsl/gsl_sf_bessel.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "averaging/diffusion.h"
#include "base/alloc.h"
#include "base/vector.h"
#include "mesh/measures.h"

enum { MOST_TERMS = 2000 };

struct diffuser {
    struct smoothing s;
    const struct cell_of_particle *cells; /* borrowed */
    double factor;                        /* [m^2] 2 / lambda */
    int products;                         /* [-] terms of the series less one */
    double c[MOST_TERMS];                 /* [-] its coefficients */
    double *link;                         /* [m] S.S / S.d of the faces */
    double *y[3], *sum;                   /* work space, `fields` a cell */
};

/* The coefficients up to where the rest of them is less than the tolerance; all
 * are positive, and together 1 (linear/chebyshev.c). */
static void smoothing_find_coefficients(struct diffuser *t, double z)
{
    double sum = 0.0, left = 1.0;
    int k = 0;

    for (; k < MOST_TERMS && (k < 2 || left > t->s.tolerance); k++) {
        t->c[k] = (k == 0 ? 1.0 : 2.0) * gsl_sf_bessel_In_scaled(k, 0.5 * z);
        sum += t->c[k];
        left = 1.0 - sum;
    }
    t->products = k - 1;
    t->c[0] += 1.0 - sum; /* so that a constant stays as it is */
}

static void *smoothing_create(const struct cell_of_particle *h,
                              const struct averaging_options *o)
{
    struct diffuser *const t = owner_create(sizeof *t);
    const struct mesh *const m = h->mesh;
    const struct smoothing *const s = o->parts;

    t->s = *s;
    t->cells = h;
    if (s->bandwidth == 0.0) return t;
    const double lambda = 2.0 * halo_largest(s->h, mesh_diffusion_rate(m));
    t->factor = lambda > 0.0 ? 2.0 / lambda : 0.0;
    smoothing_find_coefficients(t, lambda * diffusion_time(s->bandwidth));
    t->link = owner_doubles(t, m->n_internal);
    for (int f = 0; f < m->n_internal; f++) {
        const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
        t->link[f] = vector_dot(S, S) / vector_dot(S, d);
    }
    for (int i = 0; i < 3; i++)
        t->y[i] = owner_doubles(t, o->fields * m->n_cells);
    t->sum = owner_doubles(t, o->fields * m->n_cells);
    return t;
}

/* next = factor (y - (2 / lambda) L y) - before, of the own cells, and then of
 * all. */
static void smoothing_product(const struct diffuser *t, int m, double factor,
                              const double *y, const double *before,
                              double *next)
{
    const struct mesh *const mesh = t->s.mesh;
    const int n = m * mesh->n_cells;

    for (int i = 0; i < n; i++)
        next[i] = factor * y[i] - (before != NULL ? before[i] : 0.0);
    for (int f = 0; f < mesh->n_internal; f++) {
        const int o = mesh->owner[f], p = mesh->neighbour[f];
        const double g = factor * t->factor * t->link[f];
        for (int k = 0; k < m; k++) {
            const double flow = g * (y[m * o + k] - y[m * p + k]);
            next[m * o + k] -= flow / mesh->V[o];
            next[m * p + k] += flow / mesh->V[p];
        }
    }
    halo_refresh(t->s.h, m, next);
}

/* u becomes exp(-T L) u; the copies must be those of the owners. */
static void smoothing_smooth(struct diffuser *t, int m, double *u)
{
    const int n = m * t->s.mesh->n_cells;
    double *before = t->y[0], *y = t->y[1], *next = t->y[2];

    if (t->s.bandwidth == 0.0) return;
    memcpy(before, u, (size_t)n * sizeof *u);
    smoothing_product(t, m, 1.0, before, NULL, y);
    for (int i = 0; i < n; i++)
        u[i] = t->c[0] * before[i] + t->c[1] * y[i];
    for (int k = 2; k <= t->products; k++) {
        smoothing_product(t, m, 2.0, y, before, next);
        for (int i = 0; i < n; i++)
            u[i] += t->c[k] * next[i];
        double *const oldest = before;
        before = y;
        y = next;
        next = oldest;
    }
}

static void smoothing_spread(void *state, int m, const double *q, double *field,
                             struct averaging_report *r)
{
    struct diffuser *const t = state;

    cell_of_particle_sum(t->cells, m, q, field);
    halo_add(t->s.h, m, field);
    halo_refresh(t->s.h, m, field);
    smoothing_smooth(t, m, field);
    r->products = t->products;
    r->worst = (struct solve_report){.converged = 1};
}

static void smoothing_gather(void *state, int m, const double *field, double *q,
                             struct averaging_report *r)
{
    struct diffuser *const t = state;
    const double *smoothed = field;

    (void)r;
    if (t->s.bandwidth > 0.0) {
        memcpy(t->sum, field,
               (size_t)m * (size_t)t->s.mesh->n_cells * sizeof *field);
        smoothing_smooth(t, m, t->sum);
        smoothed = t->sum;
    }
    cell_of_particle_value(t->cells, m, smoothed, q);
}

const struct averaging_method smoothing_method = {
    .name = "ranks",
    .what = "pcm or diffusion over the cells of all ranks",
    .equations = "SX15 4-9",
    .function = "smoothing_smooth",
    .create = smoothing_create,
    .free = owner_free,
    .spread = smoothing_spread,
    .gather = smoothing_gather,
};
