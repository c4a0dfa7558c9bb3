/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 04-edges.c -- which cell does division give to a point on a cell's edge?
 *
 * For boxes of 1 to 50 mm with 2 to 200 equal cells: asks for the cell that
 * begins at each inner edge, once by dividing, once by mesh_cell_at.
 */
#include <stdio.h>

#include "mesh/mesh.h"

int main(void)
{
    long edges = 0, by_division = 0, by_mesh = 0;

    for (int n = 2; n <= 200; n++)
        for (int mm = 1; mm <= 50; mm++) {
            const double size = 1e-3 * mm;
            const struct box_spec spec = {
                {size, 1.0, 1.0}, {n, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
            struct mesh *const m = mesh_create_box(&spec);
            for (int i = 1; i < n; i++) {
                const double x = m->box.edge[0][i];
                edges++;
                by_division += (int)(x / size * n) != i;
                by_mesh += mesh_cell_at(m, x, 0.5, 0.5) != i;
            }
            mesh_free(m);
        }
    printf("edges = %ld\nwrong_by_division = %ld\nper_cent = %.1f\n", edges,
           by_division, 100.0 * (double)by_division / (double)edges);
    printf("wrong_by_mesh = %ld\n", by_mesh);
    return 0;
}
