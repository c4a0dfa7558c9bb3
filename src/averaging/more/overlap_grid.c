/* SPDX-License-Identifier: GPL-3.0-or-later */
/* overlap_grid.c -- one ball in the cells of a mesh of boxes. */
#include "averaging/more/overlap.h"

#include <math.h>

/* Planes closer than this fraction of R are equal [-]: those of two
 * neighbouring cells, computed by different sums. */
static const double same = 1e-9;

void overlap_grid_start(struct overlap_grid *g, double R)
{
    g->R = R;
    for (int k = 0; k < 3; k++) {
        g->n[k] = 0;
        g->plane[k][0] = -2.0; /* below all of the ball */
    }
}

/* Puts a plane at its place among those of direction k, unless it is there or
 * does not cut the ball. */
static int add_plane(struct overlap_grid *g, int k, double x)
{
    double *const plane = g->plane[k];
    int i = g->n[k];

    if (x <= -1.0 || x >= 1.0) return 1;
    while (plane[i] > x + same)
        i--;
    if (plane[i] > x - same) return 1;
    if (g->n[k] == OVERLAP_PLANES) return 0;
    for (int j = g->n[k]++; j > i; j--)
        plane[j + 1] = plane[j];
    plane[i + 1] = x;
    return 1;
}

int overlap_grid_add(struct overlap_grid *g, const double lo[3],
                     const double hi[3])
{
    for (int k = 0; k < 3; k++)
        if (!add_plane(g, k, lo[k] / g->R) || !add_plane(g, k, hi[k] / g->R))
            return 0;
    return 1;
}

/* Behind the last plane of a direction the volume is 0. */
void overlap_grid_prepare(struct overlap_grid *g)
{
    const int *const n = g->n;

    for (int i = 0; i <= n[0] + 1; i++)
        for (int j = 0; j <= n[1] + 1; j++)
            for (int k = 0; k <= n[2] + 1; k++)
                g->octant[i][j][k] =
                    i > n[0] || j > n[1] || k > n[2]
                        ? 0.0
                        : overlap_octant(g->plane[0][i], g->plane[1][j],
                                         g->plane[2][k]);
}

/* Between which planes the cell is: from the one returned to the next. */
static int overlap_grid_slab(const struct overlap_grid *g, int k, double lo)
{
    int i = g->n[k];

    while (i > 0 && g->plane[k][i] > lo / g->R + same)
        i--;
    return i;
}

double overlap_grid_cell(const struct overlap_grid *g, const double lo[3],
                         const double hi[3])
{
    double farthest = 0.0, sum = 0.0;

    for (int k = 0; k < 3; k++) {
        if (lo[k] >= g->R || hi[k] <= -g->R) return 0.0;
        const double end = fmax(fabs(lo[k]), fabs(hi[k]));
        farthest += end * end;
    }
    if (farthest <= g->R * g->R)
        return (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
    const int i = overlap_grid_slab(g, 0, lo[0]),
              j = overlap_grid_slab(g, 1, lo[1]),
              k = overlap_grid_slab(g, 2, lo[2]);
    for (int corner = 0; corner < 8; corner++) {
        const int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
        const double part = g->octant[i + x][j + y][k + z];
        sum += (x + y + z) % 2 ? -part : part;
    }
    return fmax(0.0, sum) * g->R * g->R * g->R;
}
