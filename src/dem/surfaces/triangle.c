/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/triangle.h"

#include <string.h>

#include "base/vector.h"

/* q = a + t (b - a), t from 0 to 1. */
static void nearest_on_edge(const double a[3], const double b[3], double t,
                            double q[3])
{
    for (int k = 0; k < 3; k++)
        q[k] = (1.0 - t) * a[k] + t * b[k];
}

/* The plane of the triangle falls into seven regions: beyond each of the three
 * corners, beyond each edge, and the inside. Dot products say which one holds
 * the foot of the perpendicular from y; there q is the corner, the foot on the
 * edge, or the foot itself [Ericson05 section 5.1.5]. */
void triangle_nearest(const double corner[3][3], const double y[3], double q[3])
{
    const double *const a = corner[0], *const b = corner[1];
    const double *const c = corner[2];
    double ab[3], ac[3], ay[3], by[3], cy[3];

    vector_between(b, a, ab);
    vector_between(c, a, ac);
    vector_between(y, a, ay);
    vector_between(y, b, by);
    vector_between(y, c, cy);
    const double d1 = vector_dot(ab, ay), d2 = vector_dot(ac, ay);
    const double d3 = vector_dot(ab, by), d4 = vector_dot(ac, by);
    const double d5 = vector_dot(ab, cy), d6 = vector_dot(ac, cy);
    const double A = d3 * d6 - d5 * d4; /* weights of the three corners */
    const double B = d5 * d2 - d1 * d6;
    const double C = d1 * d4 - d3 * d2;

    if (d1 <= 0.0 && d2 <= 0.0)
        memcpy(q, a, 3 * sizeof *q);
    else if (d3 >= 0.0 && d4 <= d3)
        memcpy(q, b, 3 * sizeof *q);
    else if (d6 >= 0.0 && d5 <= d6)
        memcpy(q, c, 3 * sizeof *q);
    else if (C <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
        nearest_on_edge(a, b, d1 / (d1 - d3), q);
    else if (B <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
        nearest_on_edge(a, c, d2 / (d2 - d6), q);
    else if (A <= 0.0 && d4 >= d3 && d5 >= d6)
        nearest_on_edge(b, c, (d4 - d3) / (d4 - d3 + d5 - d6), q);
    else
        for (int k = 0; k < 3; k++)
            q[k] = (A * a[k] + B * b[k] + C * c[k]) / (A + B + C);
}

void triangle_normal(const double corner[3][3], double n[3])
{
    double ab[3], ac[3];

    vector_between(corner[1], corner[0], ab);
    vector_between(corner[2], corner[0], ac);
    vector_cross(ab, ac, n);
    const double length = vector_length(n);
    for (int k = 0; k < 3; k++)
        n[k] = length > 0.0 ? n[k] / length : 0.0;
}

/* Six times the volume that the way spans with the edge from p to q. */
static double side_of_edge(const double way[3], const double from[3],
                           const double p[3], const double q[3])
{
    double to_p[3], to_q[3], area[3];

    vector_between(p, from, to_p);
    vector_between(q, from, to_q);
    vector_cross(to_p, to_q, area);
    return vector_dot(way, area);
}

int triangle_crossed(const double corner[3][3], const double a[3],
                     const double b[3])
{
    double way[3], n[3], from[3], to[3];

    triangle_normal(corner, n);
    vector_between(b, a, way);
    vector_between(a, corner[0], from);
    vector_between(b, corner[0], to);
    if (vector_dot(n, from) * vector_dot(n, to) >= 0.0) return 0;
    const double s0 = side_of_edge(way, a, corner[0], corner[1]);
    const double s1 = side_of_edge(way, a, corner[1], corner[2]);
    const double s2 = side_of_edge(way, a, corner[2], corner[0]);
    return (s0 >= 0.0 && s1 >= 0.0 && s2 >= 0.0) ||
           (s0 <= 0.0 && s1 <= 0.0 && s2 <= 0.0);
}
