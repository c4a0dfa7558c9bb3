/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/thickness.h"

#include <math.h>
#include <stdlib.h>

#include "base/vector.h"

/* Shares of the area that are looked at, each at the centroid of the triangle
 * that it falls into [-]. */
enum { POINTS = 100, THINNER = POINTS / 10 };

/* A way that meets an edge meets one of its triangles for certain [-]. */
static const double beyond_edge = 1e-9;

static void sides_of(double x[3][3], double ab[3], double ac[3], double area[3])
{
    vector_between(x[1], x[0], ab);
    vector_between(x[2], x[0], ac);
    vector_cross(ab, ac, area);
}

/* How far it is from p along n to the triangle [m], from its inner side;
 * HUGE_VAL: the way passes it by. Where it meets the plane of the triangle, the
 * weights of the corners b and c are e . ac and -e . ab over n . area, with
 * e = n x (p - a). */
static double way_to(double x[3][3], const double p[3], const double n[3])
{
    double ab[3], ac[3], area[3], from[3], e[3];

    sides_of(x, ab, ac, area);
    const double along = vector_dot(n, area);
    if (!(along > 0.0)) return HUGE_VAL;
    vector_between(p, x[0], from);
    vector_cross(n, from, e);
    const double b = vector_dot(e, ac) / along, c = -vector_dot(e, ab) / along;
    if (fmin(fmin(b, c), 1.0 - b - c) < -beyond_edge) return HUGE_VAL;
    return -vector_dot(from, area) / along;
}

static double thickness_at(int n, double (*corner)[3][3], int t)
{
    double ab[3], ac[3], area[3], p[3], least = HUGE_VAL;

    sides_of(corner[t], ab, ac, area);
    const double per = -1.0 / vector_length(area);
    for (int k = 0; k < 3; k++) {
        p[k] = (corner[t][0][k] + corner[t][1][k] + corner[t][2][k]) / 3.0;
        area[k] *= per;
    }
    for (int o = 0; o < n; o++) {
        const double way = o == t ? HUGE_VAL : way_to(corner[o], p, area);
        if (way > 0.0) least = fmin(least, way);
    }
    return least;
}

static int by_size(const void *a, const void *b)
{
    const double *const p = a, *const q = b;
    return (*p > *q) - (*p < *q);
}

static double thickness_area_of(double x[3][3])
{
    double ab[3], ac[3], area[3];

    sides_of(x, ab, ac, area);
    return vector_length(area);
}

double thickness_of(int n, double (*corner)[3][3])
{
    double all[POINTS], whole = 0.0, passed;

    for (int t = 0; t < n; t++)
        whole += thickness_area_of(corner[t]);
    passed = thickness_area_of(corner[0]);
    for (int k = 0, t = 0; k < POINTS; k++) {
        while (passed < (k + 0.5) / POINTS * whole && t + 1 < n)
            passed += thickness_area_of(corner[++t]);
        all[k] = thickness_at(n, corner, t);
    }
    qsort(all, POINTS, sizeof *all, by_size);
    return all[THINNER];
}
