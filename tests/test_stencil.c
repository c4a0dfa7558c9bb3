/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh/poly/poly.h"
#include "averaging/kernel/weights.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"
#include "warped.h"

/* Distance along k from the cell (its interval) to x. */
static double beyond(const struct mesh *m, int k, int at, double x)
{
    const double *const e = &m->box.edge[k][at];
    return fmax(0.0, fmax(e[0] - x, x - e[1]));
}

/* The number of times that the image of cell c, shifted by `link`, is among the
 * entries of the cell. Links are sums of order 1, hence 1e-12. */
static int listed(const struct stencil *s, int host, int c,
                  const double link[3])
{
    const int shape = s->shape[host];
    int n = 0;

    for (int e = s->start[shape]; e < s->start[shape + 1]; e++)
        n += host + s->index_offset[e] == c &&
             fabs(s->dx[e] - link[0]) < 1e-12 &&
             fabs(s->dy[e] - link[1]) < 1e-12 &&
             fabs(s->dz[e] - link[2]) < 1e-12;
    return n;
}

/* Looks at every image of every cell, two periods around: if it is near the
 * cell, it is listed once. Returns the number of near images, which must be the
 * number of entries. No b below has a cell just at the limit. */
static int compare_one_host(const struct mesh *m, const struct stencil *s,
                            const int at[3], double b)
{
    const int *const n = m->box.n, *const p = m->box.periodic;
    const int host = at[0] + n[0] * (at[1] + n[1] * at[2]);
    int turn[3], near = 0;

    for (int c = 0; c < m->n_cells; c++)
        for (int image = 0; image < 125; image++) {
            double link[3], r2 = 0.0;
            int skip = 0;
            turn[0] = image % 5 - 2;
            turn[1] = image / 5 % 5 - 2;
            turn[2] = image / 25 - 2;
            for (int k = 0; k < 3; k++) {
                const double L = m->box.edge[k][n[k]];
                const double x = m->centre[3 * c + k] + turn[k] * L;
                const double r = beyond(m, k, at[k], x);
                skip |= turn[k] != 0 && !(p[k] && n[k] > 1);
                link[k] = x - m->centre[3 * host + k];
                r2 += r * r;
            }
            if (skip || r2 >= b * b) continue;
            ck_assert_int_eq(listed(s, host, c, link), 1);
            near++;
        }
    return near;
}

/* 0.01: within the cell. 0.37: across more than a period of those shapes that
 * have two cells or five. */
FACT_FOR_EACH(a_stencil_contains_the_cells_near_its_own_and_no_others,
              4 * CLOUD_SHAPES)
{
    static const double b[] = {0.01, 0.11, 0.23, 0.37};
    struct mesh *const m = mesh_create_box(&cloud_shapes[_i / 4]);
    struct stencil *const s = stencil_create(m, b[_i % 4], STENCIL_TO_CENTRE);
    int at[3], c = 0;

    for (at[2] = 0; at[2] < m->box.n[2]; at[2]++)
        for (at[1] = 0; at[1] < m->box.n[1]; at[1]++)
            for (at[0] = 0; at[0] < m->box.n[0]; at[0]++, c++) {
                const int first = s->start[s->shape[c]];
                const int n = s->start[s->shape[c] + 1] - first;
                if ((c + _i) % 7 != 0) continue; /* a part will do */
                ck_assert_int_le(n, s->largest);
                ck_assert_int_eq(compare_one_host(m, s, at, b[_i % 4]), n);
                ck_assert_int_eq(s->index_offset[first], 0);
            }
    stencil_free(s);
    mesh_free(m);
}

/* Equal cells, walls all round, b of 1.6 cells reaches 2 cells off: 2 kinds of
 * cell near each wall and one between, 5 a direction. */
FACT(cells_with_equal_surroundings_share_a_stencil)
{
    struct mesh *const m = closed_box(1.2, 1.1, 1.0, 12, 11, 10);
    struct stencil *const s = stencil_create(m, 0.16, STENCIL_TO_CENTRE);

    ck_assert_int_eq(s->n_shapes, 125);
    stencil_free(s);
    mesh_free(m);
}

/* 1 if cell c has point p for a corner. */
static int has_corner(const struct mesh_shape *s, int c, int p)
{
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
        for (int a = s->start[s->polygon[i]]; a < s->start[s->polygon[i] + 1];
             a++)
            if (s->corner[a] == p) return 1;
    return 0;
}

/* Oblique, bent or of many faces: a body at a corner, however small, is in all
 * cells that have it, so they must be near each other for the smallest b. */
FACT_FOR_EACH(cells_that_share_a_corner_are_near, 3)
{
    struct mesh *const m = _i == 0 ? poly_read("tests/data/poly/sheared", NULL)
                           : _i == 1 ? poly_read("tests/data/poly/dual", NULL)
                                     : warped();
    struct stencil *const near = stencil_create(m, 1e-6, STENCIL_TO_CELL);
    int *const listed = alloc_ints(m->n_cells);

    for (int c = 0; c < m->n_cells; c++) {
        const int shape = near->shape[c];
        for (int e = near->start[shape]; e < near->start[shape + 1]; e++)
            listed[c + near->index_offset[e]] = c + 1;
        for (int p = 0; p < m->shape->n_points; p++)
            for (int b = 0; b < m->n_cells && has_corner(m->shape, c, p); b++)
                ck_assert(!has_corner(m->shape, b, p) || listed[b] == c + 1);
    }
    free(listed);
    stencil_free(near);
    mesh_free(m);
}

/* The estimate that `winnow check` gives is right within a factor of two. */
FACT(the_memory_is_known_beforehand)
{
    const struct box_spec spec = {
        {7.0, 7.0, 7.0}, {7, 7, 7}, {1.0, 1.0, 1.0}, {1, 1, 1}};
    struct mesh *const box = mesh_create_box(&spec);
    struct mesh *const m =
        mesh_create_sheared(&spec, (const double[3]){0.2, 0.0, 0.0});

    for (int i = 0; i < 4; i++) {
        const enum stencil_to to = i % 2 ? STENCIL_TO_CELL : STENCIL_TO_CENTRE;
        const double b = 0.8 + 0.3 * i;
        struct stencil *const s = stencil_create(m, b, to);
        const double entries = (double)m->n_cells * s->largest;
        const double ratio = stencil_bytes(m, b, to) / 28.0 / entries;
        ck_assert_double_gt(ratio, 0.5);
        ck_assert_double_lt(ratio, 2.0);
        ck_assert(stencil_bytes(box, b, to) == 0.0);
        stencil_free(s);
    }
    mesh_free(m);
    mesh_free(box);
}

/* Only cells that differ have a list each, in whichever direction they do. */
FACT_FOR_EACH(equal_cells_need_no_memory_and_graded_ones_do, 4)
{
    struct box_spec spec = {
        {0.8, 0.7, 0.6}, {4, 4, 4}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    if (_i < 3) spec.grading[_i] = 1.2;
    struct mesh *const m = mesh_create_box(&spec);
    const double near = stencil_bytes(m, 0.3, STENCIL_TO_CENTRE);
    const double any = stencil_bytes(m, 0.3, STENCIL_TO_CELL);
    if (_i == 3) {
        ck_assert_double_eq(near, 0.0);
        ck_assert_double_eq(any, 0.0);
    } else {
        ck_assert_double_gt(near, 0.0);
        ck_assert_double_gt(any, near);
    }
    mesh_free(m);
}
