/* SPDX-License-Identifier: GPL-3.0-or-later */
/* block_outline.c -- boxes and cylinders that turn, and their surface. */
#include "resolved/shapes/shapes.h"

#include "base/alloc.h"
#include "base/vector.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <string.h>

/* --- block outline -------------------------------------------------------- */

/* Sides of the prism that is shown of a cylinder, and that grains touch. */
enum { SIDES = 64 };

struct block {
    struct body_outline outline; /* first, because it gives the block back */
    struct body_shape shape;     /* the box or the cylinder as it is alone */
    double Q[3][3];              /* [-] turns it */
    double (*corner)[3][3];      /* [m] */
};

/* Q^T y is the point in the frame of the block. */
static double block_outline_distance(const struct body_outline *o,
                                     const double y[3])
{
    const struct block *const b = (const struct block *)o;
    double r[3];

    for (int k = 0; k < 3; k++)
        r[k] = b->Q[0][k] * y[0] + b->Q[1][k] * y[1] + b->Q[2][k] * y[2];
    return body_shape_distance(&b->shape, r);
}

/* Rodrigues: x + sin(a) n x x + (1 - cos(a)) n x (n x x), for the axes. */
static void block_outline_set_rotation(double Q[3][3], const double rotation[3])
{
    const double a = vector_length(rotation), per = a > 0.0 ? 1.0 / a : 0.0;
    const double n[3] = {per * rotation[0], per * rotation[1],
                         per * rotation[2]};

    for (int k = 0; k < 3; k++) {
        const double x[3] = {k == 0, k == 1, k == 2};
        double once[3], twice[3];
        vector_cross(n, x, once);
        vector_cross(n, once, twice);
        for (int e = 0; e < 3; e++)
            Q[e][k] = x[e] + sin(a) * once[e] + (1.0 - cos(a)) * twice[e];
    }
}

static void block_outline_turn(double Q[3][3], double x[3])
{
    const double from[3] = {x[0], x[1], x[2]};

    for (int k = 0; k < 3; k++)
        x[k] = vector_dot(Q[k], from);
}

/* The mean of x x^T over the block, before it is turned: of a box h^2 / 3 along
 * each axis, of a cylinder with the axis a R^2/4 (1 - a a^T) + h^2/3 a a^T
 * [m^2]. */
static void spread_of(const struct body_shape *shape, double C[3][3])
{
    const double *const half = shape->half, *const a = shape->axis;
    const double across = 0.25 * half[0] * half[0],
                 along = half[1] * half[1] / 3.0;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            C[i][j] =
                shape->kind == BODY_BOX
                    ? (i == j ? half[i] * half[i] / 3.0 : 0.0)
                    : (i == j ? across : 0.0) + (along - across) * a[i] * a[j];
}

static void block_outline_set_moments(struct block *b)
{
    const int *const row = body_outline_row, *const column =
                                                 body_outline_column;
    const double V = body_shape_volume(&b->shape), at_0[3] = {0.0, 0.0, 0.0};
    double C[3][3], second[6];

    spread_of(&b->shape, C);
    for (int e = 0; e < 6; e++) {
        second[e] = 0.0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                second[e] += V * b->Q[row[e]][i] * C[i][j] * b->Q[column[e]][j];
    }
    body_outline_set_moments(&b->outline, V, at_0, second);
}

/* The corners of the prism lie on a cylinder whose box they may not reach. */
static void set_surface(struct block *b)
{
    struct body_outline *const o = &b->outline;
    const int n = block_triangles_count(&b->shape);
    const double centre[3] = {0.0, 0.0, 0.0};

    b->corner = owner_zeroed(b, (size_t)n, sizeof *b->corner);
    block_triangles_put(&b->shape, centre, b->corner);
    for (int c = 0; c < 3 * n; c++) {
        double *const x = b->corner[c / 3][c % 3];
        block_outline_turn(b->Q, x);
        for (int k = 0; k < 3; k++)
            o->half[k] = fmax(o->half[k], fabs(x[k]));
    }
    o->n_triangles = n;
    o->corner = b->corner;
    if (b->shape.kind == BODY_BOX) return;
    struct body_shape turned = b->shape;
    block_outline_turn(b->Q, turned.axis);
    body_shape_extent(&turned, o->half);
}

struct body_outline *block_outline_create(const struct body_shape *block,
                                          const double rotation[3])
{
    struct block *const b = owner_create(sizeof *b);

    b->shape = *block;
    b->outline.distance = block_outline_distance;
    b->outline.width = body_shape_width(block);
    block_outline_set_rotation(b->Q, rotation);
    block_outline_set_moments(b);
    set_surface(b);
    return &b->outline;
}

/* --- block triangles ------------------------------------------------------ */

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

static void corner_of(const double centre[3], double e[3][3],
                      const double at[3], double x[3])
{
    for (int k = 0; k < 3; k++)
        x[k] = centre[k] + at[0] * e[0][k] + at[1] * e[1][k] + at[2] * e[2][k];
}

static void put_cylinder(const double centre[3], const struct body_shape *shape,
                         double (*t)[3][3])
{
    const double R = shape->half[0], L = shape->half[1];
    double e[3][3];

    vectors_across(shape->axis, e[0], e[1]);
    memcpy(e[2], shape->axis, sizeof e[2]);
    for (int s = 0; s < SIDES; s++) {
        double(*const own)[3][3] = &t[4 * s];
        double q[4][3];
        for (int v = 0; v < 4; v++) {
            const double a = 2.0 * M_PI * (s + (v == 1 || v == 2)) / SIDES;
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

int block_triangles_count(const struct body_shape *shape)
{
    return shape->kind == BODY_BOX        ? 12
           : shape->kind == BODY_CYLINDER ? 4 * SIDES
                                          : 0;
}

void block_triangles_put(const struct body_shape *shape, const double centre[3],
                         double (*t)[3][3])
{
    if (shape->kind == BODY_BOX)
        put_box(centre, shape->half, t);
    else
        put_cylinder(centre, shape, t);
}
