/* SPDX-License-Identifier: GPL-3.0-or-later */
/* two_grid.c -- particles averaged on a coarser grid of their own.
 * Chapter "Further averaging methods".
 *
 *     eps_C = sum of the V_p with their centre in C / sum_c |c and C|
 *     eps_c = sum_C |c and C| eps_C / V_c                     [LS section 5.4]
 *
 * The grid is a box of equal cells C around the mesh, as many as have at least
 * the bandwidth for their width in each direction (or one). Its size is chosen
 * for the particles, that of the mesh for the flow. |c and C| is exact for
 * cells of any shape. Volume is conserved on any mesh, because the volume of C
 * is the sum of its overlaps with the cells of the mesh.
 */
#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/cell_of_particle.h"
#include "averaging/kernel/weights.h"
#include "averaging/poly/facets.h"
#include "base/alloc.h"
#include "base/number.h"

struct two_grid {
    const struct cell_of_particle *h; /* borrowed */
    double *half;          /* [m] of a box: half extents of its cells, 3 */
    struct facets *facets; /* of another mesh */
    int n[3];              /* [-] coarse cells per direction */
    double low[3];         /* [m] where the grid begins */
    double width[3];       /* [m] of its cells */
    double *V;             /* [m^3] what the mesh has of each coarse cell */
    int *home;      /* [-] for each cell, the coarse cell of its centre */
    int *start;     /* [-] n_cells + 1; the coarse cells that cell c overlaps */
    int *other;     /* [-] other[start[c]] ... */
    double *common; /* [m^3] |c and C|, beside them */
    int *at;        /* [-] coarse cell of each particle */
    double *sum;    /* `fields` a coarse cell */
};

/* A one-cell direction of a box that is periodic in it has no inner face, and
 * its extent is to be had from the ends alone. */
static double *find_extents(const struct mesh *m)
{
    double *const half = stencil_extents(m);

    for (int k = 0; k < 3; k++)
        if (m->box.periodic[k] && m->box.n[k] == 1)
            for (int c = 0; c < m->n_cells; c++)
                half[3 * c + k] = 0.5 * (m->box.edge[k][1] - m->box.edge[k][0]);
    return half;
}

/* The coarse slab that x is in; the ends count as inside. */
static int two_grid_slab(const struct two_grid *g, int k, double x)
{
    const double at = (x - g->low[k]) / g->width[k];
    return number_clamped(at, 0, g->n[k] - 1);
}

static int coarse_at(const struct two_grid *g, const double x[3])
{
    return two_grid_slab(g, 0, x[0]) +
           g->n[0] * (two_grid_slab(g, 1, x[1]) +
                      g->n[1] * two_grid_slab(g, 2, x[2]));
}

/* The smallest box around fine cell c. */
static void two_grid_ends_of(const struct two_grid *g, int c, double lo[3],
                             double hi[3])
{
    for (int k = 0; k < 3; k++) {
        const double x = g->h->mesh->centre[3 * c + k];
        lo[k] = g->facets != NULL ? g->facets->lo[3 * c + k]
                                  : x - g->half[3 * c + k];
        hi[k] = g->facets != NULL ? g->facets->hi[3 * c + k]
                                  : x + g->half[3 * c + k];
    }
}

/* [m^3] of fine cell c, with these ends, in the coarse cell `at`. */
static double two_grid_common(const struct two_grid *g, int c,
                              const double lo[3], const double hi[3],
                              const int at[3])
{
    double begin[3], end[3], V = 1.0;

    for (int k = 0; k < 3; k++) {
        begin[k] = g->low[k] + at[k] * g->width[k];
        end[k] = begin[k] + g->width[k];
        V *= fmax(0.0, fmin(hi[k], end[k]) - fmax(lo[k], begin[k]));
    }
    return g->facets != NULL ? facets_in_box(g->facets, c, begin, end) : V;
}

/* The coarse cells that fine cell c can overlap: their number; and, unless the
 * arrays are NULL, which they are, and |c and C|. */
static int overlap_cell(const struct two_grid *g, int c, int *other,
                        double *volume)
{
    double lo[3], hi[3];
    int first[3], last[3], at[3], n = 0;

    two_grid_ends_of(g, c, lo, hi);
    for (int k = 0; k < 3; k++) {
        first[k] = two_grid_slab(g, k, lo[k]);
        last[k] = two_grid_slab(g, k, hi[k]);
    }
    for (at[2] = first[2]; at[2] <= last[2]; at[2]++)
        for (at[1] = first[1]; at[1] <= last[1]; at[1]++)
            for (at[0] = first[0]; at[0] <= last[0]; at[0]++, n++) {
                if (other == NULL) continue;
                other[n] = at[0] + g->n[0] * (at[1] + g->n[1] * at[2]);
                volume[n] = two_grid_common(g, c, lo, hi, at);
            }
    return n;
}

static void overlap_all(struct two_grid *g)
{
    const struct mesh *const m = g->h->mesh;

    g->start = owner_ints(g, m->n_cells + 1);
    for (int c = 0; c < m->n_cells; c++)
        g->start[c + 1] = g->start[c] + overlap_cell(g, c, NULL, NULL);
    g->other = owner_ints(g, g->start[m->n_cells]);
    g->common = owner_doubles(g, g->start[m->n_cells]);
    for (int c = 0; c < m->n_cells; c++) {
        const int first = g->start[c];
        overlap_cell(g, c, &g->other[first], &g->common[first]);
        g->home[c] = coarse_at(g, &m->centre[3 * c]);
        for (int a = first; a < g->start[c + 1]; a++)
            g->V[g->other[a]] += g->common[a];
    }
}

/* A box of coarse cells around the mesh; returns their number. */
static double create_grid(struct two_grid *g, double bandwidth)
{
    const struct mesh *const m = g->h->mesh;
    double high[3];
    double n = 1.0;

    for (int k = 0; k < 3; k++) {
        g->low[k] = INFINITY;
        high[k] = -INFINITY;
    }
    for (int c = 0; c < m->n_cells; c++) {
        double lo[3], hi[3];
        two_grid_ends_of(g, c, lo, hi);
        for (int k = 0; k < 3; k++) {
            g->low[k] = fmin(g->low[k], lo[k]);
            high[k] = fmax(high[k], hi[k]);
        }
    }
    for (int k = 0; k < 3; k++) {
        const double L = high[k] - g->low[k];
        /* 1e-9: as many as fit, also where rounding says almost */
        g->n[k] = number_clamped(L / bandwidth + 1e-9, 1, INT_MAX);
        g->width[k] = L / g->n[k];
        n *= g->n[k];
    }
    return n;
}

static void two_grid_free(void *state)
{
    struct two_grid *const g = state;

    free(g->half);
    owner_free(g->facets);
    owner_free(g);
}

static void *two_grid_create(const struct cell_of_particle *h,
                             const struct averaging_options *o)
{
    struct two_grid *const g = owner_create(sizeof *g);
    int n;

    g->h = h;
    if (h->mesh->shape == NULL)
        g->half = find_extents(h->mesh);
    else
        g->facets = facets_create(h->mesh);
    const int wrong = number_int(create_grid(g, o->bandwidth) * o->fields, &n);
    assert(!wrong);
    (void)wrong;
    n /= o->fields;
    g->V = owner_doubles(g, n);
    g->sum = owner_doubles(g, n * o->fields);
    g->home = owner_ints(g, h->mesh->n_cells);
    g->at = owner_ints(g, h->ps->capacity);
    overlap_all(g);
    return g;
}

/* The coarse cell of each particle; where the mesh has nothing of it, as can be
 * beyond a bent wall, that of its cell. */
static void two_grid_bind(void *state, struct averaging_report *r)
{
    struct two_grid *const g = state;

    (void)r;
    for (int i = 0; i < g->h->n; i++) {
        const int host = g->h->cell[i];
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = g->h->mesh->centre[3 * host + k] + g->h->offset[3 * i + k];
        g->at[i] = coarse_at(g, x);
        if (!(g->V[g->at[i]] > 0.0)) g->at[i] = g->home[host];
    }
}

static void two_grid_spread(void *state, int m, const double *q, double *field,
                            struct averaging_report *r)
{
    const struct two_grid *const g = state;
    const int n = g->n[0] * g->n[1] * g->n[2];
    const int n_cells = g->h->mesh->n_cells;

    (void)r;
    for (int e = 0; e < m * n; e++)
        g->sum[e] = 0.0;
    for (int i = 0; i < g->h->n; i++)
        for (int j = 0; j < m; j++)
            g->sum[m * g->at[i] + j] += q[m * i + j];
#pragma omp parallel for schedule(static)
    for (int c = 0; c < n_cells; c++) {
        double *const f = &field[m * c];
        for (int j = 0; j < m; j++)
            f[j] = 0.0;
        for (int a = g->start[c]; a < g->start[c + 1]; a++) {
            const int C = g->other[a];
            if (!(g->V[C] > 0.0)) continue;
            const double share = g->common[a] / (g->V[C] * g->h->mesh->V[c]);
            for (int j = 0; j < m; j++)
                f[j] += share * g->sum[m * C + j];
        }
    }
}

static void two_grid_gather(void *state, int m, const double *field, double *q,
                            struct averaging_report *r)
{
    const struct two_grid *const g = state;
    const int n = g->n[0] * g->n[1] * g->n[2];

    (void)r;
    for (int e = 0; e < m * n; e++)
        g->sum[e] = 0.0;
    for (int c = 0; c < g->h->mesh->n_cells; c++)
        for (int a = g->start[c]; a < g->start[c + 1]; a++)
            for (int j = 0; j < m; j++)
                g->sum[m * g->other[a] + j] += g->common[a] * field[m * c + j];
    for (int i = 0; i < g->h->n; i++)
        for (int j = 0; j < m; j++)
            q[m * i + j] = g->sum[m * g->at[i] + j] / g->V[g->at[i]];
}

const struct averaging_method two_grid_method = {
    .name = "two-grid",
    .what = "pcm on a coarser grid, then mapped to the mesh",
    .equations = "LS section 5.4",
    .function = "two_grid_spread",
    .keys = {averaging_bandwidth_keys},
    .has_own_grid = 1,
    .needs_bandwidth = 1,
    .create = two_grid_create,
    .free = two_grid_free,
    .bind = two_grid_bind,
    .spread = two_grid_spread,
    .gather = two_grid_gather,
};
