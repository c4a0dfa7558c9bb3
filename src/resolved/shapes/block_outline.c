/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/block_outline.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "resolved/shapes/block_triangles.h"

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

static void block_outline_release(struct body_outline *o)
{
    struct block *const b = (struct block *)o;

    free(b->corner);
    free(b);
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
 * [m^2].
 */
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
    const int n = block_triangles_count(&b->shape, SIDES);
    const double centre[3] = {0.0, 0.0, 0.0};

    b->corner = alloc_zeroed((size_t)n, sizeof *b->corner);
    block_triangles_put(&b->shape, SIDES, centre, b->corner);
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
    struct block *const b = alloc_zeroed(1, sizeof *b);

    b->shape = *block;
    b->outline.distance = block_outline_distance;
    b->outline.free = block_outline_release;
    b->outline.width = body_shape_width(block);
    block_outline_set_rotation(b->Q, rotation);
    block_outline_set_moments(b);
    set_surface(b);
    return &b->outline;
}
