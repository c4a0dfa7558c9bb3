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

int cell_window_cell(const struct mesh *m, const int at[3], const double x[3],
                     double r[3])
{
    const struct box *const b = &m->box;
    int in[3];

    for (int k = 0; k < 3; k++) {
        const int n = b->n[k], laps = (at[k] < 0 ? at[k] - n + 1 : at[k]) / n;
        in[k] = at[k] - laps * n;
        r[k] = 0.5 * (b->edge[k][in[k]] + b->edge[k][in[k] + 1]) +
               laps * (b->edge[k][n] - b->edge[k][0]) - x[k];
    }
    return in[0] + b->n[0] * (in[1] + b->n[1] * in[2]);
}

/* --- body cells ----------------------------------------------------------- */

void body_cells_each(const struct solid_bodies *b, const struct mesh *m, int i,
                     body_cells_act *act, void *by)
{
    const struct body_shape *const shape = &b->shape[i];
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};
    double extent[3], r[3];
    int at[3];

    body_shape_extent(shape, extent);
    const struct cell_window w = cell_window_around(m, x, extent);
    CELL_WINDOW_EACH (at, w) {
        const int c = cell_window_cell(m, at, x, r);
        act(by, i, c, r, body_shape_distance(shape, r));
    }
}
