/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/block_triangles.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

#include "base/vector.h"

/* Four corners in a round as two triangles. */
static void put_square(double (*t)[3][3], double q[4][3])
{
    memcpy(t[0][0], q[0], sizeof q[0]);
    memcpy(t[0][1], q[1], sizeof q[0]);
    memcpy(t[0][2], q[2], sizeof q[0]);
    memcpy(t[1][0], q[0], sizeof q[0]);
    memcpy(t[1][1], q[2], sizeof q[0]);
    memcpy(t[1][2], q[3], sizeof q[0]);
}

static void put_box(const double centre[3], const double half[3],
                    double (*t)[3][3])
{
    static const double round[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

    for (int side = 0; side < 6; side++) {
        const int k = side / 2, a = (k + 1) % 3, c = (k + 2) % 3;
        double q[4][3];
        for (int v = 0; v < 4; v++) {
            q[v][k] = centre[k] + (side % 2 ? half[k] : -half[k]);
            q[v][a] = centre[a] + round[v][0] * half[a];
            q[v][c] = centre[c] + round[v][1] * half[c];
        }
        put_square(&t[2 * side], q);
    }
}

/* Two unit vectors across the axis, which is the third. */
static void frame_of(const double axis[3], double e[3][3])
{
    const double other[3] = {fabs(axis[0]) < 0.5, fabs(axis[0]) >= 0.5, 0.0};

    vector_cross(axis, other, e[0]);
    const double length = vector_length(e[0]);
    for (int k = 0; k < 3; k++)
        e[0][k] /= length;
    vector_cross(axis, e[0], e[1]);
    memcpy(e[2], axis, sizeof e[2]);
}

static void corner_of(const double centre[3], double e[3][3],
                      const double at[3], double x[3])
{
    for (int k = 0; k < 3; k++)
        x[k] = centre[k] + at[0] * e[0][k] + at[1] * e[1][k] + at[2] * e[2][k];
}

static void put_cylinder(const double centre[3], const struct body_shape *shape,
                         int sides, double (*t)[3][3])
{
    const double R = shape->half[0], L = shape->half[1];
    double e[3][3];

    frame_of(shape->axis, e);
    for (int s = 0; s < sides; s++) {
        double(*const own)[3][3] = &t[4 * s];
        double q[4][3];
        for (int v = 0; v < 4; v++) {
            const double a = 2.0 * M_PI * (s + (v == 1 || v == 2)) / sides;
            const double at[3] = {R * cos(a), R * sin(a), v < 2 ? -L : L};
            corner_of(centre, e, at, q[v]);
        }
        put_square(own, q);
        for (int end = 0; end < 2; end++) {
            const double at[3] = {0.0, 0.0, end ? L : -L};
            corner_of(centre, e, at, own[2 + end][0]);
            memcpy(own[2 + end][1], q[end ? 3 : 0], sizeof q[0]);
            memcpy(own[2 + end][2], q[end ? 2 : 1], sizeof q[0]);
        }
    }
}

int block_triangles_count(const struct body_shape *shape, int sides)
{
    return shape->kind == BODY_BOX ? 12 : 4 * sides;
}

void block_triangles_put(const struct body_shape *shape, int sides,
                         const double centre[3], double (*t)[3][3])
{
    if (shape->kind == BODY_BOX)
        put_box(centre, shape->half, t);
    else
        put_cylinder(centre, shape, sides, t);
}
