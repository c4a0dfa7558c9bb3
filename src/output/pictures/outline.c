/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/picture.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

enum { SIDES = 64, ROWS = 16, MOST_CORNERS = 16 };

void outline_release(struct outline *o)
{
    free(o->x);
    free(o->corner);
    free(o->end);
    free(o->of);
    *o = (struct outline){0};
}

static void outline_reserve(struct outline *o, int points)
{
    if (o->n_points + points > o->point_room) {
        o->point_room = 2 * (o->n_points + points);
        o->x =
            alloc_grown(o->x, 3 * o->n_points, 3 * o->point_room, sizeof *o->x);
        o->corner = alloc_grown(o->corner, o->n_points, o->point_room,
                                sizeof *o->corner);
    }
    if (o->n_polygons == o->polygon_room) {
        o->polygon_room = 2 * o->n_polygons + 64;
        o->end =
            alloc_grown(o->end, o->n_polygons, o->polygon_room, sizeof *o->end);
        o->of =
            alloc_grown(o->of, o->n_polygons, o->polygon_room, sizeof *o->of);
    }
}

static void outline_add(struct outline *o, int surface, int n, double (*x)[3])
{
    if (n < 3) return;
    outline_reserve(o, n);
    for (int k = 0; k < n; k++) {
        memcpy(&o->x[3 * o->n_points], x[k], sizeof x[k]);
        o->corner[o->n_points] = o->n_points;
        o->n_points++;
    }
    o->of[o->n_polygons] = surface;
    o->end[o->n_polygons++] = o->n_points;
}

/* Clips a polygon to sign (x_k - bound) >= 0: corners outside are removed, and
 * each side that crosses the bound gets a corner there [Sutherland74]. */
static int clip(int n, double (*x)[3], int k, double sign, double bound)
{
    double kept[MOST_CORNERS][3];
    int m = 0;

    for (int i = 0; i < n; i++) {
        const double *const a = x[i], *const b = x[(i + 1) % n];
        const double u = sign * (a[k] - bound), v = sign * (b[k] - bound);
        if (u >= 0.0) memcpy(kept[m++], a, sizeof kept[0]);
        if ((u >= 0.0) == (v >= 0.0)) continue;
        for (int c = 0; c < 3; c++)
            kept[m][c] = a[c] + u / (u - v) * (b[c] - a[c]);
        m++;
    }
    memcpy(x, kept, (size_t)m * sizeof kept[0]);
    return m;
}

/* A square in the plane that is large enough to cover the box, clipped to the
 * box. */
static void draw_plane(struct outline *o, int surface, const double at[3],
                       const double n[3], const double lo[3],
                       const double hi[3])
{
    double x[MOST_CORNERS][3], e[3], f[3], size[3], middle[3], to[3];
    int corners = 4;

    vectors_across(n, e, f);
    vector_between(hi, lo, size);
    vector_along(lo, 0.5, size, middle);
    vector_between(at, middle, to);
    vector_along(middle, vector_dot(to, n), n, middle);
    const double half = vector_length(size);
    for (int c = 0; c < 4; c++) {
        vector_along(middle, c == 0 || c == 3 ? -half : half, e, x[c]);
        vector_along(x[c], c < 2 ? -half : half, f, x[c]);
    }
    for (int k = 0; k < 3 && corners > 0; k++) {
        corners = clip(corners, x, k, 1.0, lo[k]);
        if (corners > 0) corners = clip(corners, x, k, -1.0, hi[k]);
    }
    outline_add(o, surface, corners, x);
}

/* How far the box reaches along the axis from a point of it [m]. */
static void outline_along(const double at[3], const double axis[3],
                          const double lo[3], const double hi[3],
                          double range[2])
{
    range[0] = range[1] = -vector_dot(at, axis);
    for (int k = 0; k < 3; k++) {
        range[0] += axis[k] * (axis[k] > 0.0 ? lo[k] : hi[k]);
        range[1] += axis[k] * (axis[k] > 0.0 ? hi[k] : lo[k]);
    }
}

static void draw_cylinder(struct outline *o, int surface, double radius,
                          const double at[3], const double axis[3],
                          const double e[3], const double lo[3],
                          const double hi[3])
{
    double f[3], range[2];

    vector_cross(axis, e, f);
    outline_along(at, axis, lo, hi, range);
    for (int side = 0; side < SIDES; side++) {
        double x[4][3];
        for (int c = 0; c < 4; c++) {
            const double a = 2.0 * M_PI / SIDES * (side + (c == 1 || c == 2));
            vector_along(at, range[c >= 2], axis, x[c]);
            vector_along(x[c], radius * cos(a), e, x[c]);
            vector_along(x[c], radius * sin(a), f, x[c]);
        }
        outline_add(o, surface, 4, x);
    }
}

static void draw_triangles(struct outline *o, int surface,
                           const struct triangles *t, const struct pose *p)
{
    for (int i = 0; i < t->n; i++) {
        double x[3][3];
        for (int c = 0; c < 3; c++)
            motion_place(p, t->corner[i][c], x[c]);
        outline_add(o, surface, 3, x);
    }
}

/* A net of SIDES by ROWS quadrangles. */
static void draw_points(struct outline *o, int surface, const struct surface *s,
                        const struct pose *p, const double lo[3],
                        const double hi[3])
{
    for (int i = 0; i < SIDES * ROWS; i++) {
        double x[4][3], y[3];
        for (int c = 0; c < 4; c++) {
            const int side = i % SIDES + (c == 1 || c == 2), row = i / SIDES;
            s->shape->point(s, (double)side / SIDES,
                            (double)(row + c / 2) / ROWS, lo, hi, y);
            motion_place(p, y, x[c]);
        }
        outline_add(o, surface, 4, x);
    }
}

void outline_draw(struct outline *o, const struct surface *list, int n,
                  const double lo[3], const double hi[3], double t)
{
    o->n_points = o->n_polygons = 0;
    for (int s = 0; s < n; s++) {
        const struct surface *const one = &list[s];
        const struct pose p = motion_pose(&one->motion, t);
        double at[3], normal[3], e[3], f[3], turned[3];

        if (one->triangles != NULL) {
            draw_triangles(o, s, one->triangles, &p);
            continue;
        }
        if (one->shape->point != NULL) {
            draw_points(o, s, one, &p, lo, hi);
            continue;
        }
        motion_place(&p, one->point, at);
        motion_turn(&p, one->normal, normal);
        if (one->shape == &surface_plane) {
            draw_plane(o, s, at, normal, lo, hi);
            continue;
        }
        vectors_across(one->normal, e, f);
        motion_turn(&p, e, turned); /* makes its rotation visible */
        draw_cylinder(o, s, one->radius, at, normal, turned, lo, hi);
    }
}

/* The points where the sides of a polygon cross the plane; a convex one has two
 * of them, or none. */
static int section_cross(const struct outline *o, int first, int end,
                         const int axis[3], double z, double at[2][2])
{
    int n = 0;

    for (int i = first; i < end && n < 2; i++) {
        const double *const a = &o->x[3 * i];
        const double *const b = &o->x[3 * (i + 1 < end ? i + 1 : first)];
        const double u = a[axis[2]] - z, v = b[axis[2]] - z;
        if ((u >= 0.0) == (v >= 0.0)) continue;
        for (int k = 0; k < 2; k++)
            at[n][k] = a[axis[k]] + u / (u - v) * (b[axis[k]] - a[axis[k]]);
        n++;
    }
    return n;
}

void outline_section(FILE *out, const struct outline *o, const int axis[3],
                     double z)
{
    char x[NUMBER_LENGTH], y[NUMBER_LENGTH];
    double at[2][2];
    int first = 0;

    for (int p = 0; p < o->n_polygons; first = o->end[p++]) {
        if (section_cross(o, first, o->end[p], axis, z, at) < 2) continue;
        for (int i = 0; i < 2; i++)
            fprintf(out, "%s %s\n", number_rounded(at[i][0], 6, x),
                    number_rounded(at[i][1], 6, y));
        fputc('\n', out);
    }
}
