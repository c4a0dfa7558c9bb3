/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/among/body_surface.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* Sides of the prism in place of a cylinder, whose corners lie on it [-]: it is
 * thinner by 1 - cos(pi / 64) = 1.2e-3 of the radius in between. */
enum { SIDES = 64 };

static void corner_of(const double centre[3], double e[3][3],
                      const double at[3], double x[3])
{
    for (int k = 0; k < 3; k++)
        x[k] = centre[k] + at[0] * e[0][k] + at[1] * e[1][k] + at[2] * e[2][k];
}

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

static struct triangles *triangles_of_box(const double centre[3],
                                          const double half[3])
{
    double e[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double round[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    double t[12][3][3];

    for (int side = 0; side < 6; side++) {
        const int k = side / 2, a = (k + 1) % 3, c = (k + 2) % 3;
        double q[4][3];
        for (int v = 0; v < 4; v++) {
            double at[3];
            at[k] = side % 2 ? half[k] : -half[k];
            at[a] = round[v][0] * half[a];
            at[c] = round[v][1] * half[c];
            corner_of(centre, e, at, q[v]);
        }
        put_square(&t[2 * side], q);
    }
    return triangles_create(12, t);
}

/* Two unit vectors across the axis. */
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

static struct triangles *triangles_of_cylinder(const double centre[3],
                                               const struct body_shape *shape)
{
    const double R = shape->half[0], L = shape->half[1];
    double t[4 * SIDES][3][3], e[3][3];

    frame_of(shape->axis, e);
    for (int s = 0; s < SIDES; s++) {
        const double a = 2.0 * M_PI * s / SIDES,
                     c = 2.0 * M_PI * (s + 1) / SIDES;
        const double low[2][3] = {{R * cos(a), R * sin(a), -L},
                                  {R * cos(c), R * sin(c), -L}};
        double q[4][3];
        for (int v = 0; v < 4; v++) {
            const double *const from = low[v == 1 || v == 2];
            const double at[3] = {from[0], from[1], v < 2 ? -L : L};
            corner_of(centre, e, at, q[v]);
        }
        put_square(&t[4 * s], q);
        for (int end = 0; end < 2; end++) {
            const double at[3] = {0.0, 0.0, end ? L : -L};
            corner_of(centre, e, at, t[4 * s + 2 + end][0]);
            memcpy(t[4 * s + 2 + end][1], q[end ? 3 : 0], sizeof q[0]);
            memcpy(t[4 * s + 2 + end][2], q[end ? 2 : 1], sizeof q[0]);
        }
    }
    return triangles_create(4 * SIDES, t);
}

static struct triangles *triangles_of_outline(const double centre[3],
                                              const struct body_outline *o)
{
    double(*const t)[3][3] = alloc_zeroed((size_t)o->n_triangles, sizeof *t);

    for (int c = 0; c < 9 * o->n_triangles; c++)
        t[c / 9][c / 3 % 3][c % 3] =
            centre[c % 3] + o->corner[c / 9][c / 3 % 3][c % 3];
    struct triangles *const made = triangles_create(o->n_triangles, t);
    free(t);
    return made;
}

/* 1 if both ends of a cylinder are out of the box. */
static int reaches_through(const struct solid_bodies *b,
                           const struct body_shape *shape)
{
    double across = 0.0;

    for (int k = 0; k < 3; k++)
        across +=
            fabs(shape->axis[k]) * (b->contacts.hi[k] - b->contacts.lo[k]);
    return shape->half[1] >= across;
}

struct surface body_surface(const struct solid_bodies *b, int i)
{
    const struct body_shape *const shape = &b->shape[i];
    struct surface s = {.name = "a body", .shape = &surface_stl};
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};

    memcpy(s.point, x, sizeof s.point);
    s.radius = shape->half[0];
    memcpy(s.normal, shape->axis, sizeof s.normal);
    if (shape->kind == BODY_SPHERE)
        s.shape = &surface_sphere;
    else if (shape->kind == BODY_OUTLINE)
        s.triangles = triangles_of_outline(x, shape->outline);
    else if (shape->kind == BODY_BOX)
        s.triangles = triangles_of_box(x, shape->half);
    else if (reaches_through(b, shape))
        s.shape = &surface_cylinder;
    else
        s.triangles = triangles_of_cylinder(x, shape);
    return s;
}

void body_surface_release(struct surface *s)
{
    struct triangles *own;

    memcpy(&own, &s->triangles, sizeof own);
    triangles_free(own);
}
