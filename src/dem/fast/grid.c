/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/neighbours.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "base/number.h"

struct grid {
    struct box_domain box;
    int capacity;
    int axis[3];       /* [-] fastest, middle, slowest direction */
    int cells[3];      /* [-] along x, y, z */
    double origin[3];  /* [m] */
    double inverse[3]; /* [1/m] of the cell width */
    int *start;        /* [-] first particle of each cell, after the sort */
    int most;          /* [-] cells that it is long enough for */
    int *order;
};

struct grid *grid_create(int capacity, const struct box_domain *box)
{
    struct grid *const g = owner_create(sizeof *g);
    int *const axis = g->axis;

    g->box = *box;
    g->capacity = capacity;
    for (int k = 0; k < 3; k++)
        axis[k] = k;
    for (int a = 0; a < 2; a++)
        for (int c = 0; c < 2 - a; c++)
            if (box->hi[axis[c]] - box->lo[axis[c]] >
                box->hi[axis[c + 1]] - box->lo[axis[c + 1]]) {
                const int swap = axis[c];
                axis[c] = axis[c + 1];
                axis[c + 1] = swap;
            }
    g->order = owner_ints(g, capacity);
    return g;
}

void grid_free(struct grid *g)
{
    if (g == NULL) return;
    free(g->start);
    owner_free(g);
}

/* Cells over the box where it is periodic, else over the particles as they are
 * now: a little later some may be outside. */
static void span(struct grid *g, const struct particles *ps, int k,
                 double *length)
{
    const double *const x = k == 0 ? ps->x : k == 1 ? ps->y : ps->z;
    double lo = g->box.lo[k], hi = g->box.hi[k];

    if (!g->box.periodic[k] && ps->n > 0) {
        lo = hi = x[0];
        for (int i = 1; i < ps->n; i++) {
            lo = x[i] < lo ? x[i] : lo;
            hi = x[i] > hi ? x[i] : hi;
        }
    }
    g->origin[k] = lo;
    *length = hi - lo;
}

/* Cells of at least `reach`, at most so many that the arrays hold them. */
static void grid_divide(struct grid *g, const struct particles *ps,
                        double reach)
{
    double length[3];

    for (int k = 0; k < 3; k++)
        span(g, ps, k, &length[k]);
    link_cells_divide(length, ps->n > 0 ? reach : 0.0, g->capacity, g->cells);
    for (int k = 0; k < 3; k++)
        g->inverse[k] = length[k] > 0.0 ? g->cells[k] / length[k] : 0.0;
}

/* The index of the cell along axis k that contains x [m], the first or last
 * outside. */
static int grid_coordinate(const struct grid *g, int k, double x)
{
    return number_clamped((x - g->origin[k]) * g->inverse[k], 0,
                          g->cells[k] - 1);
}

/* The number of the cell at c, with the slowest index along the longest
 * side. */
static int grid_cell_number(const struct grid *g, const int c[3])
{
    const int *const a = g->axis;
    return (c[a[2]] * g->cells[a[1]] + c[a[1]]) * g->cells[a[0]] + c[a[0]];
}

/* The index of the cell along axis k in which a particle will be. */
static int grid_ahead(const struct grid *g, int k, double x, double v,
                      double ahead)
{
    return grid_coordinate(g, k, box_domain_inside(&g->box, k, x + ahead * v));
}

/* All cells, for which there is memory then. */
static int grid_cells(struct grid *g)
{
    const int n = g->cells[0] * g->cells[1] * g->cells[2];

    if (g->start == NULL || n > g->most) {
        g->most = n + n / 16;
        g->start = alloc_grown(g->start, 0, g->most + 1, sizeof *g->start);
    }
    return n;
}

/* Counting sort; particles of one cell stay in their order. */
const int *grid_order(struct grid *g, const struct particles *ps, double reach,
                      double ahead, int *cell)
{
    grid_divide(g, ps, reach);

    const int n = grid_cells(g);
    for (int c = 0; c <= n; c++)
        g->start[c] = 0;
    for (int i = 0; i < ps->n; i++) {
        const int c[3] = {grid_ahead(g, 0, ps->x[i], ps->vx[i], ahead),
                          grid_ahead(g, 1, ps->y[i], ps->vy[i], ahead),
                          grid_ahead(g, 2, ps->z[i], ps->vz[i], ahead)};
        cell[i] = grid_cell_number(g, c);
        g->start[cell[i]]++;
    }
    for (int c = 0, sum = 0; c <= n; c++) {
        sum += g->start[c];
        g->start[c] = sum; /* the end of the cell; becomes its start */
    }
    for (int i = ps->n - 1; i >= 0; i--)
        g->order[--g->start[cell[i]]] = i;
    return g->order;
}

int grid_owns(const struct grid *g, int i, int j, int n)
{
    const int ahead = j > i ? j - i : j - i + n;

    if (!g->box.periodic[g->axis[2]]) return j > i;
    return 2 * ahead < n || (2 * ahead == n && i < j);
}

/* 1 if the gap of i and j, nearest image, is less than the skin [LS 5.15]. */
static inline int close_by(const struct rows *b, int i, int j, double skin)
{
    const double reach = b->place[i].R + b->place[j].R + skin;

    return rows_distance2(&b->box, b->listed[i], b->listed[j]) <= reach * reach;
}

/* The particles from `from` to `to` - 1 of each stretch. */
struct grid_stretches {
    int n, from[27], to[27];
};

/* Cells that follow each other in the fastest direction are one stretch of
 * particles. Returns the number of the cell of i. */
static int stretches_around(const struct grid *g, const struct rows *b, int i,
                            struct grid_stretches *all)
{
    const int *const a = g->axis;
    int at[3][3], count[3], c[3], own[3];

    for (int k = 0; k < 3; k++) {
        const double x = box_domain_inside(&b->box, k, b->listed[i][k]);
        own[k] = grid_coordinate(g, k, x);
        count[k] =
            link_cells_beside(g->cells[k], g->box.periodic[k], own[k], at[k]);
    }
    all->n = 0;
    for (int p = 0; p < count[a[2]]; p++)
        for (int q = 0; q < count[a[1]]; q++)
            for (int r = 0, next; r < count[a[0]]; r = next) {
                const int *const row = at[a[0]];
                for (next = r + 1; next < count[a[0]]; next++)
                    if (row[next] != row[next - 1] + 1) break;
                c[a[2]] = at[a[2]][p];
                c[a[1]] = at[a[1]][q];
                c[a[0]] = row[r];
                const int cell = grid_cell_number(g, c);
                all->from[all->n] = g->start[cell];
                all->to[all->n++] = g->start[cell + next - r];
            }
    return grid_cell_number(g, own);
}

/* The particles around those of a cell, by columns. */
struct candidates {
    int n, capacity;
    int *j, *close; /* [-] index; 1: close to the particle at hand */
    double *x[4];   /* [m] position, radius */
};

static void candidates_free(struct candidates *of)
{
    free(of->j);
    free(of->close);
    for (int k = 0; k < 4; k++)
        free(of->x[k]);
}

static void candidates_grow(struct candidates *of, int n)
{
    if (n <= of->capacity) return;
    of->capacity = 2 * n;
    of->j = alloc_grown(of->j, of->n, of->capacity, sizeof *of->j);
    of->close = alloc_grown(of->close, 0, of->capacity, sizeof *of->close);
    for (int k = 0; k < 4; k++)
        of->x[k] = alloc_grown(of->x[k], of->n, of->capacity, sizeof(double));
}

/* Those of the stretches that follow i, in ascending order: of a stretch that
 * is not of the row of cells of i, all or none. */
static void gather_candidates(struct candidates *of,
                              const struct grid_stretches *all,
                              const struct rows *b, int i)
{
    of->n = 0;
    for (int p = 0; p < all->n; p++) {
        const int from = all->from[p] > i ? all->from[p] : i + 1;
        if (from >= all->to[p]) continue;
        candidates_grow(of, of->n + all->to[p] - from);
        for (int j = from; j < all->to[p]; j++, of->n++) {
            of->j[of->n] = j;
            for (int k = 0; k < 3; k++)
                of->x[k][of->n] = b->listed[j][k];
            of->x[3][of->n] = b->place[j].R;
        }
    }
}

/* Partners of particle i among the candidates from `first` on, all of which it
 * would own, in a box without images. Each is written to the list, and the next
 * one overwrites it unless it is close; a branch would be predicted wrongly for
 * every third. */
static void find_inside(const struct candidates *of, int first, struct chunk *s,
                        const struct rows *b, int i, double skin)
{
    const double *const p = b->listed[i], wide = b->place[i].R + skin;
    const double *const x = of->x[0], *const y = of->x[1], *const z = of->x[2];
    const double *const R = of->x[3];
    int *const close = of->close;

#pragma omp simd
    for (int a = first; a < of->n; a++) {
        const double dx = p[0] - x[a], dy = p[1] - y[a], dz = p[2] - z[a];
        const double reach = wide + R[a];
        close[a] = dx * dx + dy * dy + dz * dz <= reach * reach;
    }
    int n = 0;
    int *const to =
        of->n > first ? chunk_room_for_pairs(s, of->n - first) : NULL;
    for (int a = first; a < of->n; a++) {
        to[n] = of->j[a];
        n += close[a];
    }
    s->pairs.n += n;
}

/* 1 for two balls of one clump. */
static inline int grid_are_one(const struct rows *b, int i, int j)
{
    return b->ball != NULL && b->ball[i].of >= 0 &&
           b->ball[i].of == b->ball[j].of;
}

/* Partners of i in the stretches, one by one. */
static void find_among(const struct grid *g, const struct grid_stretches *all,
                       struct chunk *s, const struct rows *b, int i,
                       double skin)
{
    const int ring = b->box.periodic[g->axis[2]];

    for (int p = 0; p < all->n; p++)
        for (int j = !ring && all->from[p] <= i ? i + 1 : all->from[p];
             j < all->to[p]; j++)
            if (j != i && grid_owns(g, i, j, b->n) && close_by(b, i, j, skin) &&
                !grid_are_one(b, i, j)) {
                *chunk_room_for_pairs(s, 1) = j;
                s->pairs.n++;
            }
}

static void grid_find_walls(struct chunk *s, const struct rows *b, int i,
                            double skin)
{
    for (int w = 0; w < 6; w++)
        if (!b->box.periodic[w / 2] &&
            box_domain_gap(&b->box, w, b->listed[i]) - b->place[i].R <= skin)
            chunk_add_wall(s, w);
}

/* The particles of a cell follow each other, and have the same around them. */
void grid_find(const struct grid *g, struct chunk *s, const struct rows *b,
               double skin)
{
    const int *const around = b->box.periodic;
    const int plain = !around[0] && !around[1] && !around[2] && b->ball == NULL;
    struct grid_stretches all = {0};
    struct candidates of = {0};

    chunk_clear_lists(s);
    for (int i = s->begin, first = i, end = i; i < s->end; i++) {
        if (i == end) {
            const int cell = stretches_around(g, b, i, &all);
            first = i;
            end = g->start[cell] <= i && i < g->start[cell + 1]
                      ? g->start[cell + 1]
                      : i + 1;
            if (plain) gather_candidates(&of, &all, b, i);
        }
        chunk_begin_owner(s, i);
        if (plain)
            find_inside(&of, i - first, s, b, i, skin);
        else
            find_among(g, &all, s, b, i, skin);
        grid_find_walls(s, b, i, skin);
    }
    candidates_free(&of);
    chunk_finish_lists(s, b->n);
}
