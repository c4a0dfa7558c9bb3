/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_shape.h"

#include <stddef.h>

#include "base/alloc.h"
#include "base/rotation.h"
#include "base/vector.h"

#include <gsl/gsl_math.h>
#include <math.h>

struct body_shape body_shape_sphere(double diameter)
{
    return (struct body_shape){.kind = BODY_SPHERE, .half = {0.5 * diameter}};
}

struct body_shape body_shape_box(const double size[3])
{
    return (struct body_shape){
        .kind = BODY_BOX,
        .half = {0.5 * size[0], 0.5 * size[1], 0.5 * size[2]}};
}

struct body_shape body_shape_cylinder(double diameter, double length,
                                      const double axis[3])
{
    const double per = 1.0 / vector_length(axis);
    return (struct body_shape){
        .kind = BODY_CYLINDER,
        .half = {0.5 * diameter, 0.5 * length},
        .axis = {per * axis[0], per * axis[1], per * axis[2]}};
}

int body_shape_along(const struct body_shape *shape, int k)
{
    return fabs(shape->axis[k]) > 1.0 - 1e-12;
}

struct body_shape body_shape_outline(struct body_outline *outline)
{
    const double *const half = outline->half;
    return (struct body_shape){.kind = BODY_OUTLINE,
                               .half = {half[0], half[1], half[2]},
                               .outline = outline,
                               .turn = {{1.0}, {0.0, 1.0}, {0.0, 0.0, 1.0}}};
}

/* How far a point is beyond each of n pairs of parallel or round sides makes
 * its distance from all of them: inside the nearest one counts. */
static double body_shape_beyond(int n, const double q[])
{
    double outside = 0.0, nearest = -HUGE_VAL;

    for (int k = 0; k < n; k++) {
        outside += fmax(q[k], 0.0) * fmax(q[k], 0.0);
        nearest = fmax(nearest, q[k]);
    }
    return nearest > 0.0 ? sqrt(outside) : nearest;
}

static double distance_of_box(const double half[3], const double r[3])
{
    const double q[3] = {fabs(r[0]) - half[0], fabs(r[1]) - half[1],
                         fabs(r[2]) - half[2]};
    return body_shape_beyond(3, q);
}

static double distance_of_cylinder(const struct body_shape *c,
                                   const double r[3])
{
    const double along = vector_dot(r, c->axis);
    double across[3];

    vector_along(r, -along, c->axis, across);
    const double q[2] = {vector_length(across) - c->half[0],
                         fabs(along) - c->half[1]};
    return body_shape_beyond(2, q);
}

/* y = Q^T r, in the frame of the body. */
static double distance_of_outline(const struct body_shape *shape,
                                  const double r[3])
{
    const double(*const Q)[3] = shape->turn;
    double y[3];

    for (int k = 0; k < 3; k++)
        y[k] = Q[0][k] * r[0] + Q[1][k] * r[1] + Q[2][k] * r[2];
    return shape->outline->distance(shape->outline, y);
}

double body_shape_distance(const struct body_shape *shape, const double r[3])
{
    switch (shape->kind) {
    case BODY_BOX:
        return distance_of_box(shape->half, r);
    case BODY_CYLINDER:
        return distance_of_cylinder(shape, r);
    case BODY_OUTLINE:
        return distance_of_outline(shape, r);
    default:
        return vector_length(r) - shape->half[0];
    }
}

void body_shape_normal(const struct body_shape *shape, const double r[3],
                       double n[3])
{
    const double step = 1e-4 * shape->half[0];

    for (int k = 0; k < 3; k++) {
        double a[3] = {r[0], r[1], r[2]}, c[3] = {r[0], r[1], r[2]};
        a[k] -= step;
        c[k] += step;
        n[k] = body_shape_distance(shape, c) - body_shape_distance(shape, a);
    }
    const double length = vector_length(n);
    for (int k = 0; k < 3; k++)
        n[k] = length > 0.0 ? n[k] / length : k == 1;
}

void body_shape_extent(const struct body_shape *shape, double extent[3])
{
    const double *const half = shape->half;

    for (int k = 0; k < 3; k++) {
        const double a = shape->axis[k], *const q = shape->turn[k];
        extent[k] =
            shape->kind == BODY_BOX ? half[k]
            : shape->kind == BODY_OUTLINE
                ? fabs(q[0]) * half[0] + fabs(q[1]) * half[1] +
                      fabs(q[2]) * half[2]
            : shape->kind == BODY_CYLINDER
                ? half[0] * sqrt(fmax(1.0 - a * a, 0.0)) + half[1] * fabs(a)
                : half[0];
    }
}

double body_shape_volume(const struct body_shape *shape)
{
    const double *const half = shape->half;

    if (shape->kind == BODY_OUTLINE) return shape->outline->volume;
    if (shape->kind == BODY_BOX) return 8.0 * half[0] * half[1] * half[2];
    if (shape->kind == BODY_CYLINDER)
        return 2.0 * M_PI * half[0] * half[0] * half[1];
    return 4.0 / 3.0 * M_PI * half[0] * half[0] * half[0];
}

double body_shape_width(const struct body_shape *shape)
{
    const double *const half = shape->half;
    double R = half[0];

    if (shape->kind == BODY_BOX) R = fmin(R, fmin(half[1], half[2]));
    if (shape->kind == BODY_CYLINDER) R = fmin(R, half[1]);
    if (shape->kind != BODY_OUTLINE) return 2.0 * R;
    if (shape->outline->width > 0.0) return shape->outline->width;
    R = 0.0;
    for (int k = 0; k < shape->outline->n_balls; k++)
        R = fmax(R, shape->outline->ball[k].R);
    return 2.0 * R;
}

int body_shape_balls(const struct body_shape *shape)
{
    return shape->kind == BODY_SPHERE    ? 1
           : shape->kind == BODY_OUTLINE ? shape->outline->n_balls
                                         : 0;
}

struct body_ball body_shape_ball(const struct body_shape *shape, int k)
{
    struct body_ball b = {.R = shape->half[0]};

    if (shape->kind != BODY_OUTLINE) return b;
    b.R = shape->outline->ball[k].R;
    for (int e = 0; e < 3; e++)
        b.at[e] = vector_dot(shape->turn[e], shape->outline->ball[k].at);
    return b;
}

/* --- body outline --------------------------------------------------------- */

const int body_outline_row[6] = {0, 0, 0, 1, 1, 2},
          body_outline_column[6] = {0, 1, 2, 1, 2, 2};

/* C = <(x - c)(x - c)^T>, and the moments over the mass are tr C - C. */
void body_outline_set_moments(struct body_outline *o, double V,
                              const double first[3], const double second[6])
{
    const int *const row = body_outline_row, *const column =
                                                 body_outline_column;
    double C[6];

    o->volume = V;
    for (int k = 0; k < 3; k++)
        o->centre[k] = first[k] / V;
    for (int e = 0; e < 6; e++)
        C[e] = second[e] / V - o->centre[row[e]] * o->centre[column[e]];
    const double trace = C[0] + C[3] + C[5];
    for (int e = 0; e < 6; e++)
        o->gyration[e] = (row[e] == column[e] ? trace : 0.0) - C[e];
    rotation_principal(o->gyration, o->principal, o->moments);
}

void body_outline_free(struct body_outline *o)
{
    if (o != NULL && !o->kept) owner_free(o);
}

int body_outline_spans(const struct body_outline *o, int k, double L, double h)
{
    double lo = HUGE_VAL, hi = -HUGE_VAL;

    for (int c = 0; c < 3 * o->n_triangles; c++) {
        lo = fmin(lo, o->corner[c / 3][c % 3][k]);
        hi = fmax(hi, o->corner[c / 3][c % 3][k]);
    }
    return hi - lo > L - 0.5 * h;
}
