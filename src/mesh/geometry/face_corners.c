/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/geometry/face_corners.h"

#include <stddef.h>
#include <string.h>

/* The corners of a face of a box, which is a rectangle. */
static int box_corners(const struct mesh *m, int f, int max, double (*x)[3])
{
    const int *const n = m->box.n, c = m->owner[f];
    const int at[3] = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
    const double *const S = &m->S[3 * f];
    int k = 0;

    while (S[k] == 0.0)
        k++;
    const int a = (k + 1) % 3, b = (k + 2) % 3, upper = S[k] > 0.0;
    for (int i = 0; i < 4 && i < max; i++) {
        const int corner = upper ? i : 3 - i;
        x[i][k] = m->box.edge[k][at[k] + upper];
        x[i][a] = m->box.edge[a][at[a] + (corner == 1 || corner == 2)];
        x[i][b] = m->box.edge[b][at[b] + (corner >= 2)];
    }
    return 4;
}

int face_corners(const struct mesh *m, int f, int max, double (*x)[3])
{
    const struct mesh_shape *const s = m->shape;

    if (s == NULL) return box_corners(m, f, max, x);
    const int p = s->boundary[f - m->n_internal];
    const int n = s->start[p + 1] - s->start[p];
    for (int i = 0; i < n && i < max; i++)
        memcpy(x[i], &s->point[3 * s->corner[s->start[p] + i]], sizeof x[i]);
    return n;
}

void face_corners_middle(const struct mesh *m, int f, double x[3])
{
    const int c = m->owner[f];

    for (int k = 0; k < 3; k++)
        x[k] = m->face_centre != NULL ? m->face_centre[3 * f + k]
                                      : m->centre[3 * c + k] + m->d[3 * f + k];
}
