/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/triangles.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

/* --- triangle ------------------------------------------------------------- */

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

/* --- triangles ------------------------------------------------------------ */

enum { MOST_CELLS_A_SIDE = 128 };

/* The smallest and the largest coordinate of one triangle. */
static void extent(const double corner[3][3], int k, double *lo, double *hi)
{
    *lo = fmin(corner[0][k], fmin(corner[1][k], corner[2][k]));
    *hi = fmax(corner[0][k], fmax(corner[1][k], corner[2][k]));
}

/* The cell of a coordinate, or the one at the end that it lies beyond. */
static int triangles_cell_of(const struct triangles *t, int k, double x)
{
    return number_clamped((x - t->lo[k]) * t->inverse[k], 0, t->cells[k] - 1);
}

static void triangles_range_of(const struct triangles *t, int i, int first[3],
                               int last[3])
{
    for (int k = 0; k < 3; k++) {
        double lo, hi;
        extent((const double(*)[3])t->corner[i], k, &lo, &hi);
        first[k] = triangles_cell_of(t, k, lo);
        last[k] = triangles_cell_of(t, k, hi);
    }
}

static int triangles_cell_number(const struct triangles *t, int x, int y, int z)
{
    return (z * t->cells[1] + y) * t->cells[0] + x;
}

/* Cells as wide as the mean triangle. */
static void triangles_divide(struct triangles *t)
{
    for (int k = 0; k < 3; k++) {
        double sum = 0.0;
        t->lo[k] = HUGE_VAL;
        t->hi[k] = -HUGE_VAL;
        for (int i = 0; i < t->n; i++) {
            double lo, hi;
            extent((const double(*)[3])t->corner[i], k, &lo, &hi);
            t->lo[k] = fmin(t->lo[k], lo);
            t->hi[k] = fmax(t->hi[k], hi);
            sum += hi - lo;
        }
        const double length = t->hi[k] - t->lo[k], width = sum / t->n;
        const double n = width > 0.0 ? length / width : 1.0;
        t->cells[k] = number_clamped(n, 1, MOST_CELLS_A_SIDE);
        t->inverse[k] = length > 0.0 ? t->cells[k] / length : 0.0;
    }
}

/* Counts, or with `member` fills in from the back. */
static void enter(struct triangles *t, int *member)
{
    for (int i = t->n - 1; i >= 0; i--) {
        int first[3], last[3];
        triangles_range_of(t, i, first, last);
        for (int z = first[2]; z <= last[2]; z++)
            for (int y = first[1]; y <= last[1]; y++)
                for (int x = first[0]; x <= last[0]; x++) {
                    int *const c = &t->start[triangles_cell_number(t, x, y, z)];
                    if (member != NULL)
                        member[--*c] = i;
                    else
                        ++*c;
                }
    }
}

struct triangles *triangles_create(int n, double (*corner)[3][3])
{
    struct triangles *const t = owner_create(sizeof *t);

    t->n = n;
    t->corner = owner_zeroed(t, (size_t)n, sizeof *t->corner);
    memcpy(t->corner, corner, (size_t)n * sizeof *t->corner);
    triangles_divide(t);

    const int cells = t->cells[0] * t->cells[1] * t->cells[2];
    t->start = owner_ints(t, cells + 1);
    enter(t, NULL);
    for (int c = 0, sum = 0; c <= cells; c++) {
        sum += t->start[c];
        t->start[c] = sum; /* the end of the cell; becomes its start */
    }
    t->member = owner_ints(t, t->start[cells]);
    enter(t, t->member);
    return t;
}

/* 1 if this cell is the first one that both the search and the triangle have.
 */
static int is_first_common_cell(const struct triangles *t, int i,
                                const int from[3], const int cell[3])
{
    int first[3], last[3];

    triangles_range_of(t, i, first, last);
    for (int k = 0; k < 3; k++)
        if (cell[k] != (first[k] > from[k] ? first[k] : from[k])) return 0;
    return 1;
}

static int triangles_is_within(const struct triangles *t, int i,
                               const double y[3], double reach)
{
    for (int k = 0; k < 3; k++) {
        double lo, hi;
        extent((const double(*)[3])t->corner[i], k, &lo, &hi);
        if (y[k] + reach < lo || y[k] - reach > hi) return 0;
    }
    return 1;
}

static void search(const struct triangles *t, const double y[3], double reach,
                   const int from[3], const int cell[3],
                   struct triangle_list *found)
{
    const int c = triangles_cell_number(t, cell[0], cell[1], cell[2]);

    for (int q = t->start[c]; q < t->start[c + 1]; q++) {
        const int i = t->member[q];
        if (!is_first_common_cell(t, i, from, cell) ||
            !triangles_is_within(t, i, y, reach))
            continue;
        found->number = alloc_room(found->number, found->n, &found->capacity,
                                   sizeof *found->number);
        found->number[found->n++] = i;
    }
}

void triangles_near(const struct triangles *t, const double y[3], double reach,
                    struct triangle_list *found)
{
    int from[3], to[3];

    found->n = 0;
    for (int k = 0; k < 3; k++) {
        if (y[k] + reach < t->lo[k] || y[k] - reach > t->hi[k]) return;
        from[k] = triangles_cell_of(t, k, y[k] - reach);
        to[k] = triangles_cell_of(t, k, y[k] + reach);
    }
    for (int z = from[2]; z <= to[2]; z++)
        for (int x = from[1]; x <= to[1]; x++)
            for (int w = from[0]; w <= to[0]; w++)
                search(t, y, reach, from, (const int[3]){w, x, z}, found);
}
