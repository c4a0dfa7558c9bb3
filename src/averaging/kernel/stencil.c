/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/kernel/weights.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "mesh/measures.h"

/* How many of the newest shapes are compared with a new one, and the tolerance:
 * above the rounding of a sum of links, and far below what affects a kernel. */
enum { LOOK_BACK = 1024 };
static const double alike = 1e-10; /* [-] of b or the largest cell */

/* Half the extents of a cell of a box: how far its face centres are from its
 * own. The owner's share of the link d is 1 - w, also at the boundary, where w
 * = 0. */
static void half_extents(const struct mesh *m, int c, double half[3])
{
    half[0] = half[1] = half[2] = 0.0;
    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        const double own = m->owner[f] == c ? 1.0 - m->w[f] : 0.0;
        const double other =
            f < m->n_internal && m->neighbour[f] == c ? m->w[f] : 0.0;
        for (int k = 0; k < 3; k++)
            half[k] = fmax(half[k], fmax(own, other) * fabs(mesh_d(m, f)[k]));
    }
}

/* The same where the corners are known. */
static void half_by_corners(const struct mesh *m, int c, double half[3])
{
    const struct mesh_shape *const s = m->shape;

    half[0] = half[1] = half[2] = 0.0;
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++) {
        const int p = s->polygon[i];
        for (int a = s->start[p]; a < s->start[p + 1]; a++)
            for (int k = 0; k < 3; k++)
                half[k] = fmax(half[k], fabs(s->point[3 * s->corner[a] + k] -
                                             m->centre[3 * c + k]));
    }
}

double *stencil_extents(const struct mesh *m)
{
    double *const half = alloc_doubles(3 * m->n_cells);

    for (int c = 0; c < m->n_cells; c++)
        if (m->shape != NULL)
            half_by_corners(m, c, &half[3 * c]);
        else
            half_extents(m, c, &half[3 * c]);
    return half;
}

/* The entries found so far from one cell. */
struct walk {
    const struct mesh *m;
    double b;     /* [m] */
    double alike; /* [m] links closer than this lead to the same position */
    double *half; /* [m] half extents of each cell, 3 */
    enum stencil_to to;
    int n, room;
    int *cell;    /* [-] */
    int *other;   /* [-] an earlier entry of the same cell, or -1 */
    double *link; /* [m] 3 an entry, from the cell */
    int *latest;  /* [-] n_cells; latest entry of a cell, or -1 */
};

/* Adds the image of cell c at the link unless it is there already. */
static void walk_add(struct walk *w, int c, const double link[3])
{
    for (int e = w->latest[c]; e >= 0; e = w->other[e]) {
        double apart = 0.0;
        for (int k = 0; k < 3; k++)
            apart = fmax(apart, fabs(w->link[3 * e + k] - link[k]));
        if (apart < w->alike) return;
    }
    if (w->n == w->room) {
        w->room = 2 * w->room + 64;
        w->cell = alloc_grown(w->cell, w->n, w->room, sizeof *w->cell);
        w->other = alloc_grown(w->other, w->n, w->room, sizeof *w->other);
        w->link = alloc_grown(w->link, w->n, w->room, 3 * sizeof *w->link);
    }
    w->cell[w->n] = c;
    w->other[w->n] = w->latest[c];
    memcpy(&w->link[3 * w->n], link, 3 * sizeof *link);
    w->latest[c] = w->n++;
}

/* 1 if cell c, with its centre at the link, is nearer than b to the cell. */
static int stencil_is_near(const struct walk *w, int c, const double link[3])
{
    double r2 = 0.0;

    for (int k = 0; k < 3; k++) {
        const double own = w->to == STENCIL_TO_CELL ? w->half[3 * c + k] : 0.0;
        const double half = w->half[3 * w->cell[0] + k] + own;
        const double beyond = fmax(0.0, fabs(link[k]) - half);
        r2 += beyond * beyond;
    }
    return r2 < w->b * w->b;
}

/* Looks through the faces of entry e for cells that are near. */
static void stencil_walk_on(struct walk *w, int e)
{
    const struct mesh *const m = w->m;
    const int c = w->cell[e];

    for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
        const int f = m->cell_face[a];
        if (f >= m->n_internal) return; /* ascending: only boundary follows */
        for (int side = 0; side < 2; side++) {
            const int here = side == 0 ? m->owner[f] : m->neighbour[f];
            const int there = side == 0 ? m->neighbour[f] : m->owner[f];
            double link[3];
            if (here != c) continue;
            for (int k = 0; k < 3; k++)
                link[k] = w->link[3 * e + k] +
                          (side == 0 ? mesh_d(m, f)[k] : -mesh_d(m, f)[k]);
            if (stencil_is_near(w, there, link)) walk_add(w, there, link);
        }
    }
}

static void stencil_walk_from(struct walk *w, int host)
{
    const double nowhere[3] = {0.0, 0.0, 0.0};

    for (int e = 0; e < w->n; e++)
        w->latest[w->cell[e]] = -1;
    w->n = 0;
    walk_add(w, host, nowhere);
    for (int e = 0; e < w->n; e++) /* n grows as the walk goes on */
        stencil_walk_on(w, e);
}

static int same_shape(const struct stencil *s, int shape, const struct walk *w)
{
    const int first = s->start[shape];

    if (s->start[shape + 1] - first != w->n) return 0;
    for (int e = 0; e < w->n; e++) {
        const int at = first + e;
        if (s->index_offset[at] != w->cell[e] - w->cell[0] ||
            fabs(s->dx[at] - w->link[3 * e]) > w->alike ||
            fabs(s->dy[at] - w->link[3 * e + 1]) > w->alike ||
            fabs(s->dz[at] - w->link[3 * e + 2]) > w->alike)
            return 0;
    }
    return 1;
}

/* The stored shape that equals the present one, newest first; -1 if there is
 * none. */
static int known_shape(const struct stencil *s, const struct walk *w)
{
    for (int i = s->n_shapes; i-- > 0 && i >= s->n_shapes - LOOK_BACK;)
        if (same_shape(s, i, w)) return i;
    return -1;
}

/* Appends the walk as a shape; `room` is the capacity of the entries. There are
 * never more shapes than cells, so start is allocated for all cells from the
 * beginning. */
static void stencil_add_shape(struct stencil *s, const struct walk *w,
                              int *room)
{
    const int first = s->start[s->n_shapes];

    if (first + w->n > *room) {
        *room = 2 * *room + w->n;
        s->index_offset =
            alloc_grown(s->index_offset, first, *room, sizeof *s->index_offset);
        s->dx = alloc_grown(s->dx, first, *room, sizeof *s->dx);
        s->dy = alloc_grown(s->dy, first, *room, sizeof *s->dy);
        s->dz = alloc_grown(s->dz, first, *room, sizeof *s->dz);
    }
    for (int e = 0; e < w->n; e++) {
        s->index_offset[first + e] = w->cell[e] - w->cell[0];
        s->dx[first + e] = w->link[3 * e];
        s->dy[first + e] = w->link[3 * e + 1];
        s->dz[first + e] = w->link[3 * e + 2];
    }
    s->start[++s->n_shapes] = first + w->n;
    if (w->n > s->largest) s->largest = w->n;
}

struct stencil *stencil_create(const struct mesh *m, double b,
                               enum stencil_to to)
{
    struct stencil *const s = owner_create(sizeof *s);
    struct walk w = {.m = m,
                     .b = b,
                     .alike = alike * b,
                     .half = stencil_extents(m),
                     .to = to,
                     .latest = alloc_ints(m->n_cells)};
    int room = 0;

    for (int i = 0; i < 3 * m->n_cells; i++)
        w.alike = fmax(w.alike, alike * w.half[i]);
    s->shape = owner_ints(s, m->n_cells);
    s->start = owner_ints(s, m->n_cells + 1);
    for (int c = 0; c < m->n_cells; c++)
        w.latest[c] = -1;
    for (int c = 0; c < m->n_cells; c++) {
        stencil_walk_from(&w, c);
        s->shape[c] = known_shape(s, &w);
        if (s->shape[c] >= 0) continue;
        s->shape[c] = s->n_shapes;
        stencil_add_shape(s, &w, &room);
    }
    free(w.half);
    free(w.cell);
    free(w.other);
    free(w.link);
    free(w.latest);
    return s;
}

static int stencil_has_equal_cells(const struct mesh *m)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < m->box.n[k]; i++) {
            const double *const e = m->box.edge[k];
            const double mean = (e[m->box.n[k]] - e[0]) / m->box.n[k];
            if (fabs(e[i + 1] - e[i] - mean) > 1e-6 * mean) return 0;
        }
    return m->shape == NULL;
}

/* The number of cells in the volume nearer than b to a cube: to the cell itself
 * for their centres, to a cube twice as wide for any part of them. */
double stencil_bytes(const struct mesh *m, double b, enum stencil_to to)
{
    const double entry = sizeof(int) + 3.0 * sizeof(double);
    const double side = to == STENCIL_TO_CENTRE ? 1.0 : 2.0;
    double least, most, volume;

    if (stencil_has_equal_cells(m)) return 0.0;
    mesh_volumes(m, &least, &most, &volume);
    const double x = b / cbrt(volume); /* in widths of a cell */
    const double cells = gsl_pow_3(side) + 6.0 * side * side * x +
                         3.0 * M_PI * side * x * x +
                         4.0 / 3.0 * M_PI * x * x * x;
    return m->n_cells * entry * fmin(cells, m->n_cells);
}

void stencil_free(struct stencil *s)
{
    if (s == NULL) return;
    free(s->index_offset);
    free(s->dx);
    free(s->dy);
    free(s->dz);
    owner_free(s);
}
