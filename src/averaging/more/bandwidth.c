/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/bandwidth.h"

#include <gsl/gsl_math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

struct bandwidth {
    const struct cell_of_particle *h; /* borrowed */
    double b;                         /* [m] of the options */
    int by_cells, by_grains;
    double *base;  /* [-] (b(x) / b)^2 of each cell by region */
    double *local; /* [-] the same with its grains */
    double *D;     /* [-] of each internal face */
};

const struct model bandwidth_cells = {
    .name = "cells",
    .what = "reduced by the width that a cell smears by itself",
    .equations = "SX15 section 2.2.3",
    .function = "bandwidth_minus_cell",
};

const struct model bandwidth_grains = {
    .name = "grains",
    .what = "proportional to the mean diameter of the grains in a cell",
    .equations = "SX15 section 2.2.3",
    .function = "follow_grains",
};

static int bandwidth_is_in(const struct averaging_region *r, const double x[3])
{
    for (int k = 0; k < 3; k++)
        if (x[k] < r->low[k] || x[k] > r->high[k]) return 0;
    return 1;
}

static void find_base(struct bandwidth *w, const struct averaging_options *o)
{
    const struct mesh *const m = w->h->mesh;

    for (int c = 0; c < m->n_cells; c++) {
        w->base[c] = 1.0;
        for (int i = 0; i < o->regions.n; i++)
            if (bandwidth_is_in(&o->regions.item[i], &m->centre[3 * c]))
                w->base[c] = gsl_pow_2(o->regions.item[i].bandwidth / w->b);
    }
}

/* Sum of V_p and of V_p d over the particles of cell c. */
static void add_grains(const struct cell_of_particle *h, int c, double sum[2])
{
    for (int a = h->start[c]; a < h->start[c + 1]; a++) {
        const double V = particles_volume(h->ps, h->particle[a]);
        sum[0] += V;
        sum[1] += V * h->ps->d[h->particle[a]];
    }
}

static void follow_grains(struct bandwidth *w)
{
    const int n = w->h->mesh->n_cells;
    double all[2] = {0.0, 0.0};

    for (int c = 0; c < n; c++)
        add_grains(w->h, c, all);
    for (int c = 0; c < n; c++) {
        double own[2] = {0.0, 0.0};
        add_grains(w->h, c, own);
        const double ratio =
            own[0] > 0.0 ? own[1] / own[0] * all[0] / all[1] : 1.0;
        w->local[c] = w->base[c] * ratio * ratio;
    }
}

/* Subtracts the variance that a cell adds to a Gaussian of bandwidth b(x),
 * b(x)^2 = D b^2 [SX15 section 2.2.3]. */
double bandwidth_minus_cell(double D, double dx, double b)
{
    return fmax(0.0, D - dx * dx / (3.0 * b * b));
}

int bandwidth_is_by_lines(const struct averaging_options *o)
{
    return strcmp(o->vary, "grains") != 0 && o->regions.n == 0;
}

static void bandwidth_find_faces(struct bandwidth *w)
{
    const struct mesh *const m = w->h->mesh;

    for (int f = 0; f < m->n_internal; f++) {
        const double P = w->local[m->owner[f]], N = w->local[m->neighbour[f]];
        const double D = P + N > 0.0 ? 2.0 * P * N / (P + N) : 0.0;
        const double dx = vector_length(mesh_d(m, f));
        w->D[f] = w->by_cells ? bandwidth_minus_cell(D, dx, w->b) : D;
    }
}

struct bandwidth *bandwidth_create(const struct cell_of_particle *h,
                                   const struct averaging_options *o)
{
    struct bandwidth *const w = owner_create(sizeof *w);

    w->h = h;
    w->b = o->bandwidth;
    w->by_cells = strcmp(o->vary, "cells") == 0;
    w->by_grains = strcmp(o->vary, "grains") == 0;
    w->base = owner_doubles(w, h->mesh->n_cells);
    w->local = owner_doubles(w, h->mesh->n_cells);
    w->D = owner_doubles(w, h->mesh->n_internal);
    find_base(w, o);
    memcpy(w->local, w->base, (size_t)h->mesh->n_cells * sizeof *w->base);
    bandwidth_find_faces(w);
    return w;
}

const double *bandwidth_D(const struct bandwidth *w)
{
    return w->D;
}

int bandwidth_bind(struct bandwidth *w)
{
    if (!w->by_grains) return 0;
    follow_grains(w);
    bandwidth_find_faces(w);
    return 1;
}

double bandwidth_largest(const struct bandwidth *w)
{
    const struct particles *const ps = w->h->ps;
    double base = 0.0, d_max = 0.0, volume = 0.0, sum = 0.0;

    for (int c = 0; c < w->h->mesh->n_cells; c++)
        base = fmax(base, w->base[c]);
    if (!w->by_grains || ps->n == 0) return base;
    for (int i = 0; i < ps->n; i++) {
        const double V = particles_volume(ps, i);
        d_max = fmax(d_max, ps->d[i]);
        volume += V;
        sum += V * ps->d[i];
    }
    return base * gsl_pow_2(d_max * volume / sum);
}

int bandwidth_has_rule(const char *vary)
{
    return strcmp(vary, "uniform") == 0 || strcmp(vary, "cells") == 0 ||
           strcmp(vary, "grains") == 0;
}
