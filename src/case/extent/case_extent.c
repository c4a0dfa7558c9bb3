/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/extent/case_extent.h"

#include "case/case_mesh.h"

double case_extent_cells(const struct settings *s)
{
    const struct mesh *const kept = settings_mesh(s);
    const int *const n = s->mesh.box.cells;

    return kept != NULL ? kept->n_cells : (double)n[0] * n[1] * n[2];
}

/* Of a box the product of its sides. */
double case_extent_volume(const struct settings *s)
{
    const struct mesh *const m = settings_mesh(s);
    const double *const size = s->mesh.box.size;
    double sum = 0.0;

    for (int c = 0; m != NULL && c < m->n_cells; c++)
        sum += m->V[c];
    if (m != NULL) return sum;
    return size[0] * size[1] * size[2];
}

int case_extent_holds(const struct settings *s, const double x[3])
{
    const struct mesh *const m = settings_mesh(s);
    double lo[3], hi[3], offset[3];

    if (m != NULL) return mesh_cell_and_offset(m, x, offset) >= 0;
    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++)
        if (!(x[k] >= lo[k] && x[k] <= hi[k])) return 0;
    return 1;
}
