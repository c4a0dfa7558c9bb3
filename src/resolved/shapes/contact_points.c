/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/shapes/shapes.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

/* Points along the longest side of a body [-], at most: for thin plates. */
enum { most_along = 48 };

/* A point nearer to another one than this share of the spacing is left out. */
static const double least_apart = 0.5;

/* Points are in one plane if they are this share of the width apart. */
static const double flat = 1e-2;

struct cloud {
    double (*x)[3];
    int n, capacity;
};

static void contact_points_put(struct cloud *all, const double x[3])
{
    all->x = alloc_room(all->x, all->n, &all->capacity, sizeof *all->x);
    memcpy(all->x[all->n++], x, sizeof *all->x);
}

static double longest_side(double t[3][3])
{
    double most = 0.0;

    for (int k = 0; k < 3; k++) {
        double side[3];
        vector_between(t[(k + 1) % 3], t[k], side);
        most = fmax(most, vector_length(side));
    }
    return most;
}

/* The corners of a grid in the triangle, whose sides are not longer than the
 * spacing [m]. Those of the triangle itself come with i or j or both 0. */
static void put_triangle(struct cloud *all, double t[3][3], double spacing)
{
    const int n = number_clamped(ceil(longest_side(t) / spacing * (1.0 - 1e-9)),
                                 1, 2 * most_along);

    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n - i; j++) {
            double x[3];
            for (int k = 0; k < 3; k++)
                x[k] = t[0][k] + (double)i / n * (t[1][k] - t[0][k]) +
                       (double)j / n * (t[2][k] - t[0][k]);
            contact_points_put(all, x);
        }
}

static int outer_first(const void *a, const void *b)
{
    const double *const p = a, *const q = b;
    const double P = vector_dot(p, p), Q = vector_dot(q, q);

    for (int k = 0; k < 3 && P == Q; k++)
        if (p[k] != q[k]) return p[k] > q[k] ? 1 : -1;
    return (P < Q) - (P > Q);
}

/* The outer ones stay, the tips of a body among them. */
static void thin_out(struct cloud *all, double apart)
{
    int kept = 0;

    qsort(all->x, (size_t)all->n, sizeof *all->x, outer_first);
    for (int i = 0; i < all->n; i++) {
        int j = 0;
        for (double r[3]; j < kept; j++) {
            vector_between(all->x[i], all->x[j], r);
            if (vector_dot(r, r) < apart * apart) break;
        }
        if (j == kept) memmove(all->x[kept++], all->x[i], sizeof *all->x);
    }
    all->n = kept;
}

/* How many are in the outermost plane across a direction [-]. */
static int in_plane(const struct cloud *all, const double n[3], double depth)
{
    double highest = -HUGE_VAL;
    int count = 0;

    for (int i = 0; i < all->n; i++)
        highest = fmax(highest, vector_dot(all->x[i], n));
    for (int i = 0; i < all->n; i++)
        count += vector_dot(all->x[i], n) > highest - depth;
    return count;
}

static int most_in_plane(const struct body_outline *o, const struct cloud *all)
{
    int most = 1;

    for (int t = 0; t < o->n_triangles; t++) {
        double a[3], b[3], n[3];
        vector_between(o->corner[t][1], o->corner[t][0], a);
        vector_between(o->corner[t][2], o->corner[t][0], b);
        vector_cross(a, b, n);
        vector_unit(n, n);
        const int count = in_plane(all, n, flat * o->width);
        most = count > most ? count : most;
    }
    return most;
}

void contact_points_add(struct body_outline *o)
{
    const double longest = 2.0 * fmax(o->half[0], fmax(o->half[1], o->half[2]));
    const double spacing = fmax(0.5 * o->width, longest / most_along);
    struct cloud all = {0};

    for (int t = 0; t < o->n_triangles; t++)
        put_triangle(&all, o->corner[t], spacing);
    thin_out(&all, least_apart * spacing);
    o->flat = most_in_plane(o, &all);
    o->n_balls = all.n;
    o->ball = owner_zeroed(o, (size_t)all.n, sizeof *o->ball);
    for (int i = 0; i < all.n; i++)
        memcpy(o->ball[i].at, all.x[i], sizeof all.x[i]);
    free(all.x);
}

/* 1 if it is as far as that from its centre in all directions across axis k. */
static int is_round(const struct body_outline *o, int k, double R)
{
    enum { DIRECTIONS = 32 };

    for (int i = 0; i < DIRECTIONS; i++) {
        const double a = 2.0 * M_PI * i / DIRECTIONS;
        double y[3] = {0.0, 0.0, 0.0};
        y[(k + 1) % 3] = R * cos(a);
        y[(k + 2) % 3] = R * sin(a);
        if (fabs(o->distance(o, y)) > flat * R) return 0;
    }
    return 1;
}

void contact_points_between(struct body_outline *o, int k)
{
    const double R = o->half[(k + 1) % 3];
    int kept = 0;

    if (is_round(o, k, R)) {
        o->ball[0] = (struct body_ball){.R = R};
        o->n_balls = o->flat = 1;
        return;
    }
    for (int i = 0; i < o->n_balls; i++) {
        double *const x = o->ball[i].at, r[3];
        int j = 0;
        x[k] = 0.0;
        for (; j < kept; j++) {
            vector_between(x, o->ball[j].at, r);
            if (vector_length(r) < flat * o->width) break;
        }
        if (j == kept && o->distance(o, x) > -flat * o->width)
            o->ball[kept++] = o->ball[i];
    }
    o->n_balls = kept;
}
