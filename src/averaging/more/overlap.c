/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The planes x = a, y = b, z = c cut off a corner of the ball. With the centre
 * as origin the divergence of the place is 3, and so the volume is a third of
 * the area of the part of the sphere, less a third of a times the area of the
 * part of the plane x = a, and so on. The area on the sphere is what the
 * theorem of Gauss and Bonnet leaves of 2 pi: the angles at the corners, and
 * the bend of the circles between them.
 *
 * All angles are taken as atan2 of lengths that come from one root: where the
 * sphere nearly touches an edge and terms cancel, their errors then cancel,
 * too. */
#include "averaging/more/overlap.h"

#include <gsl/gsl_math.h>
#include <math.h>

/* Volume of the part x > a of the unit ball: a cap. */
static double cap(double a)
{
    const double h = 1.0 - a; /* height */

    if (a <= -1.0) return 4.0 / 3.0 * M_PI;
    return a < 1.0 ? M_PI / 3.0 * h * h * (3.0 - h) : 0.0;
}

/* The part x > a, y > b. */
static double wedge(double a, double b)
{
    if (a >= 1.0 || b >= 1.0) return 0.0;
    if (a <= -1.0) return cap(b);
    if (b <= -1.0) return cap(a);
    if (a < 0.0) return cap(b) - wedge(-a, b); /* complement of x < a */
    if (b < 0.0) return cap(a) - wedge(a, -b);
    const double w2 = 1.0 - a * a - b * b;
    if (w2 <= 0.0) return 0.0;
    const double w = sqrt(w2); /* the edge ends at z = w and -w */
    const double angle = atan2(w, a * b);
    const double arc_a = 2.0 * atan2(w, b); /* of the circle x = a */
    const double arc_b = 2.0 * atan2(w, a);
    return 2.0 / 3.0 * (angle + a * b * w) -
           0.5 * (a * (1.0 - a * a / 3.0) * arc_a +
                  b * (1.0 - b * b / 3.0) * arc_b);
}

/* The part x > a, y > b, z > c with all three from 0 on and the corner within
 * the ball. */
static double corner(double a, double b, double c)
{
    const double u = sqrt(1.0 - b * b - c * c); /* ends of the three edges */
    const double v = sqrt(1.0 - c * c - a * a);
    const double w = sqrt(1.0 - a * a - b * b);
    const double angles = atan2(u, b * c) + atan2(v, c * a) + atan2(w, a * b);
    const double arc_a = atan2(w, b) - atan2(c, v);
    const double arc_b = atan2(u, c) - atan2(a, w);
    const double arc_c = atan2(v, a) - atan2(b, u);

    return (angles - M_PI + b * c * u + c * a * v + a * b * w) / 3.0 -
           a * b * c -
           0.5 * (a * (1.0 - a * a / 3.0) * arc_a +
                  b * (1.0 - b * b / 3.0) * arc_b +
                  c * (1.0 - c * c / 3.0) * arc_c);
}

double overlap_octant(double a, double b, double c)
{
    if (a >= 1.0 || b >= 1.0 || c >= 1.0) return 0.0;
    if (a <= -1.0) return wedge(b, c);
    if (b <= -1.0) return wedge(c, a);
    if (c <= -1.0) return wedge(a, b);
    if (a < 0.0) return wedge(b, c) - overlap_octant(-a, b, c);
    if (b < 0.0) return wedge(c, a) - overlap_octant(a, -b, c);
    if (c < 0.0) return wedge(a, b) - overlap_octant(a, b, -c);
    return a * a + b * b + c * c < 1.0 ? corner(a, b, c) : 0.0;
}

/* Distance of the nearest and of the farthest point of the box, squared. */
static void distances(const double lo[3], const double hi[3], double *nearest,
                      double *farthest)
{
    *nearest = *farthest = 0.0;
    for (int k = 0; k < 3; k++) {
        const double beside = fmax(0.0, fmax(lo[k], -hi[k]));
        const double end = fmax(fabs(lo[k]), fabs(hi[k]));
        *nearest += beside * beside;
        *farthest += end * end;
    }
}

double overlap_sphere(double R, const double lo[3], const double hi[3])
{
    double nearest, farthest, sum = 0.0;

    distances(lo, hi, &nearest, &farthest);
    if (nearest >= R * R) return 0.0;
    if (farthest <= R * R)
        return (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
    for (int k = 0; k < 8; k++) {
        const int far = (k & 1) + (k >> 1 & 1) + (k >> 2 & 1);
        const double part = overlap_octant((k & 1 ? hi[0] : lo[0]) / R,
                                           (k & 2 ? hi[1] : lo[1]) / R,
                                           (k & 4 ? hi[2] : lo[2]) / R);
        sum += far % 2 ? -part : part;
    }
    return fmax(0.0, sum) * R * R * R; /* rounding of 1e-16 around nothing */
}

double overlap_cube(double R, const double lo[3], const double hi[3])
{
    double volume = 1.0;

    for (int k = 0; k < 3; k++)
        volume *= fmax(0.0, fmin(hi[k], R) - fmax(lo[k], -R));
    return volume;
}

/* One ball in the cells of a mesh of boxes. */

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
