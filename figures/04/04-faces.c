/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 04-faces.c -- the faces of a small mesh, as a list and as things to draw.
 *
 * 3 by 2 cells, graded in x, periodic in y, one cell deep in z (whose two
 * patches are left out here).
 */
#include <stdio.h>

#include "mesh/mesh.h"

static void print_face(const struct mesh *m, int f)
{
    const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
    const double *const x = &m->centre[3 * m->owner[f]];
    const int inner = f < m->n_internal;
    const double way = inner ? 1.0 - m->w[f] : 1.0; /* of d, to the face */
    char beyond[8] = "-";

    if (inner) snprintf(beyond, sizeof beyond, "%d", m->neighbour[f]);
    printf("%4d %5d %9s  %5.2f %5.2f  %5.2f %5.2f  %5.3f  %6.3f %6.3f\n", f,
           m->owner[f], beyond, S[0], S[1], d[0], d[1], m->w[f],
           x[0] + way * d[0], x[1] + way * d[1]);
}

int main(void)
{
    const struct box_spec spec = {
        {4.0, 2.0, 1.0}, {3, 2, 1}, {2.0, 1.0, 1.0}, {0, 1, 0}};
    struct mesh *const m = mesh_create_box(&spec);

    printf("cell  centre         V\n");
    for (int c = 0; c < m->n_cells; c++)
        printf("%4d %6.3f %6.3f %6.3f\n", c, m->centre[3 * c],
               m->centre[3 * c + 1], m->V[c]);
    printf(
        "\n\nface owner neighbour    S_x   S_y    d_x   d_y      w  centre\n");
    for (int f = 0; f < m->n_internal; f++)
        print_face(m, f);
    for (int i = 0; i < m->n_patches; i++)
        for (int k = 0; m->patches[i].name[0] != 'b' &&
                        m->patches[i].name[0] != 'f' && k < m->patches[i].n;
             k++)
            print_face(m, m->patches[i].first + k);
    mesh_free(m);
    return 0;
}
