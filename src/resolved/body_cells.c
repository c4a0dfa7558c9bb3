/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_cells.h"

#include "resolved/cell_window.h"

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
