/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/two_grid.h"

#include <math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/hosts.h"
#include "averaging/stencil.h"
#include "base/alloc.h"

struct two_grid {
    const struct hosts *h; /* borrowed */
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

/* The corners of the smallest box around the mesh. */
static void find_ends(const struct mesh *m, const double *half, double low[3],
                      double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (int c = 0; c < m->n_cells; c++) {
            const double x = m->centre[3 * c + k];
            low[k] = fmin(low[k], x - half[3 * c + k]);
            high[k] = fmax(high[k], x + half[3 * c + k]);
        }
    }
}

/* A one-cell direction of a mesh that is periodic in it has no inner face, and
 * its extent is to be had from the box alone. */
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
static int slab(const struct two_grid *g, int k, double x)
{
    const double at = floor((x - g->low[k]) / g->width[k]);
    return (int)fmax(0.0, fmin(g->n[k] - 1, at));
}

static int coarse_at(const struct two_grid *g, const double x[3])
{
    return slab(g, 0, x[0]) +
           g->n[0] * (slab(g, 1, x[1]) + g->n[1] * slab(g, 2, x[2]));
}

/* [m] of the interval lo .. hi that is in slab j of direction k. */
static double inside(const struct two_grid *g, int k, int j, double lo,
                     double hi)
{
    const double begin = g->low[k] + j * g->width[k];
    return fmax(0.0, fmin(hi, begin + g->width[k]) - fmax(lo, begin));
}

/* The coarse cells that fine cell c overlaps: their number; and, if there is
 * room for them, which, and |c and C|. */
static int overlap_cell(const struct two_grid *g, int c, const double *half,
                        int *other, double *common)
{
    const double *const x = &g->h->mesh->centre[3 * c];
    const double box = 8.0 * half[0] * half[1] * half[2];
    const double scale = g->h->mesh->V[c] / box; /* 1 for a box */
    int first[3], last[3], n = 0;

    for (int k = 0; k < 3; k++) {
        first[k] = slab(g, k, x[k] - half[k]);
        last[k] = slab(g, k, x[k] + half[k]);
    }
    for (int l = first[2]; l <= last[2]; l++)
        for (int j = first[1]; j <= last[1]; j++)
            for (int i = first[0]; i <= last[0]; i++, n++) {
                if (other == NULL) continue;
                other[n] = i + g->n[0] * (j + g->n[1] * l);
                common[n] = scale *
                            inside(g, 0, i, x[0] - half[0], x[0] + half[0]) *
                            inside(g, 1, j, x[1] - half[1], x[1] + half[1]) *
                            inside(g, 2, l, x[2] - half[2], x[2] + half[2]);
            }
    return n;
}

static void overlap_all(struct two_grid *g, const double *half)
{
    const struct mesh *const m = g->h->mesh;

    g->start = alloc_ints(m->n_cells + 1);
    for (int c = 0; c < m->n_cells; c++)
        g->start[c + 1] =
            g->start[c] + overlap_cell(g, c, &half[3 * c], NULL, NULL);
    g->other = alloc_ints(g->start[m->n_cells]);
    g->common = alloc_doubles(g->start[m->n_cells]);
    for (int c = 0; c < m->n_cells; c++) {
        const int first = g->start[c];
        overlap_cell(g, c, &half[3 * c], &g->other[first], &g->common[first]);
        g->home[c] = coarse_at(g, &m->centre[3 * c]);
        for (int a = first; a < g->start[c + 1]; a++)
            g->V[g->other[a]] += g->common[a];
    }
}

static void *two_grid_create(const struct hosts *h,
                             const struct averaging_options *o)
{
    struct two_grid *const g = alloc_zeroed(1, sizeof *g);
    double *const half = find_extents(h->mesh);
    double high[3];
    int n = 1;

    g->h = h;
    find_ends(h->mesh, half, g->low, high);
    for (int k = 0; k < 3; k++) {
        const double L = high[k] - g->low[k];
        /* 1e-9: as many as fit, also where rounding says almost */
        g->n[k] = (int)fmax(1.0, floor(L / o->bandwidth + 1e-9));
        g->width[k] = L / g->n[k];
        n *= g->n[k];
    }
    g->V = alloc_doubles(n);
    g->sum = alloc_doubles(n * o->fields);
    g->home = alloc_ints(h->mesh->n_cells);
    g->at = alloc_ints(h->ps->capacity);
    overlap_all(g, half);
    free(half);
    return g;
}

static void two_grid_free(void *state)
{
    struct two_grid *const g = state;

    free(g->V);
    free(g->home);
    free(g->start);
    free(g->other);
    free(g->common);
    free(g->at);
    free(g->sum);
    free(g);
}

/* The coarse cell of each particle; where the mesh has nothing of it, which
 * can only be outside of a box, that of its host. */
static void two_grid_bind(void *state, struct averaging_report *r)
{
    struct two_grid *const g = state;

    (void)r;
    for (int i = 0; i < g->h->n; i++) {
        const int host = g->h->host[i];
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
    .cite = "LS section 5.4",
    .what = "pcm on a coarser grid, then moved to the mesh",
    .function = "two_grid_spread",
    .wide = 1,
    .create = two_grid_create,
    .free = two_grid_free,
    .bind = two_grid_bind,
    .spread = two_grid_spread,
    .gather = two_grid_gather,
};
