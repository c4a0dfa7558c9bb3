/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_cells.h"

#include "base/number.h"

#include <math.h>

/* --- cell window ---------------------------------------------------------- */

enum { farthest = 1 << 29 }; /* a cell that no body reaches */

/* Index of the cell of a direction at x [m]; equal cells, which go on beyond
 * the mesh. */
static int index_at(const struct box *b, int k, double x)
{
    const double width = (b->edge[k][b->n[k]] - b->edge[k][0]) / b->n[k];
    return number_clamped(floor((x - b->edge[k][0]) / width), -farthest,
                          farthest);
}

struct cell_window cell_window_around(const struct mesh *m, const double x[3],
                                      const double extent[3])
{
    struct cell_window w;

    for (int k = 0; k < 3; k++) {
        const double *const edge = m->box.edge[k];
        const int n = m->box.n[k], here = index_at(&m->box, k, x[k]);
        w.first[k] = index_at(&m->box, k, x[k] - extent[k]) - 1;
        w.last[k] = index_at(&m->box, k, x[k] + extent[k]) + 1;
        if (m->box.periodic[k] && 2.0 * extent[k] >= edge[n] - edge[0]) {
            w.first[k] = here - n / 2; /* from end to end: each cell once */
            w.last[k] = w.first[k] + n - 1;
        }
        if (m->box.periodic[k]) continue;
        if (w.first[k] < 0) w.first[k] = 0;
        if (w.last[k] >= m->box.n[k]) w.last[k] = m->box.n[k] - 1;
    }
    return w;
}

/* The index in the mesh of a place along direction k, and how far its cell's
 * centre is from x [m]. */
static int place_along(const struct box *b, int k, int at, double x, double *r)
{
    const int n = b->n[k];
    int laps = 0; /* counted, because a division takes longer */

    for (; at < 0; at += n)
        laps--;
    for (; at >= n; at -= n)
        laps++;
    *r = 0.5 * (b->edge[k][at] + b->edge[k][at + 1]) +
         laps * (b->edge[k][n] - b->edge[k][0]) - x;
    return at;
}

int cell_window_cell(const struct mesh *m, const int at[3], const double x[3],
                     double r[3])
{
    const struct box *const b = &m->box;
    int in[3];

    for (int k = 0; k < 3; k++)
        in[k] = place_along(b, k, at[k], x[k], &r[k]);
    return in[0] + b->n[0] * (in[1] + b->n[1] * in[2]);
}

/* --- body cells ----------------------------------------------------------- */

/* A body whose cells are looked at. */
struct body_visit {
    const struct body_shape *shape;
    int i;
    double x[3], reach; /* [m] */
    body_cells_act *act;
    void *by;
};

/* How many of the next cells of width h in a row are on the same side of the
 * surface as one at the distance s, and beyond reach as well [-]. */
static int alike_after(double s, double reach, double h)
{
    const double rounding = 1e-6; /* one just within reach is looked at */

    return fabs(s) > reach
               ? number_clamped((fabs(s) - reach) / h - rounding, 0, farthest)
               : 0;
}

/* Those of a row that begins with cell `row` and is at r[1], r[2]. */
static void cells_of_row(const struct body_visit *v, const struct box *box,
                         const struct cell_window *w, int row, double r[3])
{
    const double h = box->edge[0][1] - box->edge[0][0];

    for (int at = w->first[0], alike; at <= w->last[0]; at++) {
        int c = row + place_along(box, 0, at, v->x[0], &r[0]);
        const double s = body_shape_distance(v->shape, r);
        alike = alike_after(s, v->reach, h);
        if (s > v->reach) {
            at += alike;
            continue;
        }
        v->act(v->by, v->i, c, r, s);
        for (; alike > 0 && at < w->last[0]; alike--) {
            c = row + place_along(box, 0, ++at, v->x[0], &r[0]);
            v->act(v->by, v->i, c, r, -v->reach);
        }
    }
}

void body_cells_each(const struct solid_bodies *b, const struct mesh *m, int i,
                     double reach, body_cells_act *act, void *by)
{
    const struct box *const box = &m->box;
    const struct body_visit v = {.shape = &b->shape[i],
                                 .i = i,
                                 .x = {b->ps->x[i], b->ps->y[i], b->ps->z[i]},
                                 .reach = reach,
                                 .act = act,
                                 .by = by};
    double extent[3], r[3];

    body_shape_extent(v.shape, extent);
    const struct cell_window w = cell_window_around(m, v.x, extent);
    for (int z = w.first[2]; z <= w.last[2]; z++) {
        const int layer = box->n[1] * place_along(box, 2, z, v.x[2], &r[2]);
        for (int y = w.first[1]; y <= w.last[1]; y++) {
            const int row = layer + place_along(box, 1, y, v.x[1], &r[1]);
            cells_of_row(&v, box, &w, box->n[0] * row, r);
        }
    }
}
