/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/triangles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"

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
    struct triangles *const t = alloc_zeroed(1, sizeof *t);

    t->n = n;
    t->corner = alloc_zeroed((size_t)n, sizeof *t->corner);
    memcpy(t->corner, corner, (size_t)n * sizeof *t->corner);
    triangles_divide(t);

    const int cells = t->cells[0] * t->cells[1] * t->cells[2];
    t->start = alloc_ints(cells + 1);
    enter(t, NULL);
    for (int c = 0, sum = 0; c <= cells; c++) {
        sum += t->start[c];
        t->start[c] = sum; /* the end of the cell; becomes its start */
    }
    t->member = alloc_ints(t->start[cells]);
    enter(t, t->member);
    return t;
}

void triangles_free(struct triangles *t)
{
    if (t == NULL) return;
    free(t->corner);
    free(t->start);
    free(t->member);
    free(t);
}

static void triangles_add(struct triangle_list *list, int i)
{
    if (list->n == list->capacity) {
        list->capacity = 2 * list->capacity + 64;
        list->number = alloc_grown(list->number, list->n, list->capacity,
                                   sizeof *list->number);
    }
    list->number[list->n++] = i;
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
        if (is_first_common_cell(t, i, from, cell) &&
            triangles_is_within(t, i, y, reach))
            triangles_add(found, i);
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
