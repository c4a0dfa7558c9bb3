/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/pair_share.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/effects.h"
#include "dem/dem_internal.h"
#include "dem/link_cells.h"

enum { MEASURED = 8 }; /* [-] one step in so many, for the cost */

struct pair_share {
    const struct attraction *attraction; /* borrowed */
    struct link_cells *cells;
    double *strongest; /* [N] force on each particle */
};

void *pair_share_create(struct simulation *sim,
                        const struct attraction_law *law)
{
    const struct dem_options *const o = &sim->dem->options;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    const struct attraction *found = NULL;

    for (int k = 0; k < o->n_attractions; k++)
        if (o->attractions[k].law == law) found = &o->attractions[k];
    if (found == NULL) return NULL;
    struct pair_share *const self = alloc_zeroed(1, sizeof *self);
    self->attraction = found;
    self->cells = link_cells_create(sim->particles->capacity, &box);
    self->strongest = alloc_doubles(sim->particles->capacity);
    return self;
}

void pair_share_free(void *memory)
{
    struct pair_share *const self = memory;

    if (self == NULL) return;
    link_cells_free(self->cells);
    free(self->strongest);
    free(self);
}

static void position(const struct particles *ps, int i, double x[3])
{
    x[0] = ps->x[i];
    x[1] = ps->y[i];
    x[2] = ps->z[i];
}

static void pair_share_sort(struct pair_share *self, const struct particles *ps)
{
    double widest = 0.0, x[3];

    for (int i = 0; i < ps->n; i++)
        widest = fmax(widest, ps->d[i]);
    link_cells_clear(self->cells, widest + self->attraction->range);
    for (int i = 0; i < ps->n; i++) {
        position(ps, i, x);
        link_cells_add(self->cells, i, x);
    }
}

/* The force [N] between i and j; x [m] from j to i. */
static double pair_share_force(const struct pair_share *self,
                               const struct simulation *sim, int i, int j,
                               const double x[3])
{
    const struct attraction *const a = self->attraction;
    const struct particles *const ps = sim->particles;
    const double R = 0.5 * ps->d[i], S = 0.5 * ps->d[j], r = vector_length(x);
    const double v[3] = {ps->vx[i] - ps->vx[j], ps->vy[i] - ps->vy[j],
                         ps->vz[i] - ps->vz[j]};
    const int *const of = ps->material;
    double F = 0.0;

    if (r - R - S > a->range) return 0.0;
    if (a->law->pair != NULL)
        F += a->law->pair(a, of != NULL ? of[i] : 0, of != NULL ? of[j] : 0, R,
                          S, r - R - S);
    if (a->law->damping != NULL)
        F += attraction_damp(
            a, R * S / (R + S), r - R - S, -vector_dot(v, x) / r,
            1.0 / ps->m[i] + 1.0 / ps->m[j], sim->dem->options.step);
    return fabs(F);
}

/* Raises the strongest force of i by those of the walls of the box. */
static void pair_share_add_walls(struct pair_share *self,
                                 const struct simulation *sim, int i)
{
    const struct attraction *const a = self->attraction;
    const struct particles *const ps = sim->particles;
    const double R = 0.5 * ps->d[i], v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
    double x[3];

    position(ps, i, x);
    for (int w = 0; w < 6; w++) {
        const double gap = box_domain_gap(&self->cells->box, w, x) - R;
        const double closing = w % 2 ? v[w / 2] : -v[w / 2];
        double F = 0.0;
        if (self->cells->box.periodic[w / 2] || gap > a->range) continue;
        if (a->law->wall != NULL) F += a->law->wall(a, R, gap);
        if (a->law->damping != NULL)
            F += attraction_damp(a, R, gap, closing, 1.0 / ps->m[i],
                                 sim->dem->options.step);
        self->strongest[i] = fmax(self->strongest[i], fabs(F));
    }
}

/* Raises the strongest forces of i and of its partners with a larger index. */
static void pair_share_add_partners(struct pair_share *self,
                                    const struct simulation *sim, int i)
{
    const struct particles *const ps = sim->particles;
    int cell[LINK_CELLS_AROUND];
    double x[3], y[3];

    position(ps, i, x);
    const int n = link_cells_around(self->cells, x, cell);
    for (int c = 0; c < n; c++)
        for (int j = self->cells->head[cell[c]]; j >= 0;
             j = self->cells->next[j]) {
            if (j <= i) continue;
            position(ps, j, y);
            for (int k = 0; k < 3; k++)
                y[k] = box_domain_nearest(&self->cells->box, k, x[k] - y[k]);
            const double F = pair_share_force(self, sim, i, j, y);
            self->strongest[i] = fmax(self->strongest[i], F);
            self->strongest[j] = fmax(self->strongest[j], F);
        }
}

void pair_share_after_step(void *memory, struct simulation *sim)
{
    struct pair_share *const self = memory;
    const int n = sim->particles->n;

    if (self == NULL || sim->steps % MEASURED != 1) return;
    memset(self->strongest, 0, (size_t)n * sizeof *self->strongest);
    pair_share_sort(self, sim->particles);
    for (int i = 0; i < n; i++) {
        pair_share_add_walls(self, sim, i);
        pair_share_add_partners(self, sim, i);
    }
    for (int i = 0; i < n; i++) {
        const double f[3] = {self->strongest[i], 0.0, 0.0};
        effects_report(sim, f, 1.0);
    }
}
