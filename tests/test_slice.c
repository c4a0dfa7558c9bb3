/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/picture.h"

#include "facts.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"

/* --- slices --------------------------------------------------------------- */

/* A fluid that turns about the middle of a box of one cell along `thin`. */
static struct slice turning(int thin, double **u, double **p)
{
    struct box_spec spec = {{2.0, 2.0, 2.0}, {20, 20, 20}, {1, 1, 1}, {0}};
    spec.size[thin] = 5.0;
    spec.cells[thin] = 1;
    struct mesh *const m = mesh_create_box(&spec);
    const int a = thin == 0 ? 2 : 0, b = thin == 1 ? 2 : 1;

    *u = alloc_doubles(3 * m->n_cells);
    *p = alloc_doubles(m->n_cells);
    for (int c = 0; c < m->n_cells; c++) {
        (*u)[3 * c + a] = -(m->centre[3 * c + b] - 1.0);
        (*u)[3 * c + b] = m->centre[3 * c + a] - 1.0;
        (*p)[c] = m->centre[3 * c + a];
    }
    const struct slice s =
        slice_of(m, *u, *p, (double[3]){0.0, 1.0, 0.0}, 10000);
    mesh_free(m);
    return s;
}

/* The plane is normal to the direction of one cell, though it is the longest;
 * between the centres of cells a linear field is exact. */
FACT_FOR_EACH(a_slice_shows_the_plane_that_a_flow_lies_in, 3)
{
    double *u, *p, w[2];
    struct slice s = turning(_i, &u, &p);
    const double x[2] = {1.3, 0.6}, outside[2] = {1.0, 2.1};

    ck_assert_int_ne(s.axis[0], _i);
    ck_assert_int_ne(s.axis[1], _i);
    ck_assert_int_eq(s.n[0], s.n[1]);
    ck_assert_int_eq(slice_velocity(&s, x, w), 1);
    ck_assert_double_eq_tol(w[0], 0.4, 1e-12);
    ck_assert_double_eq_tol(w[1], 0.3, 1e-12);
    ck_assert_int_eq(slice_velocity(&s, outside, w), 0);
    const int middle = s.n[0] / 2 + s.n[0] * (s.n[1] / 2);
    ck_assert_double_eq_tol(s.p[middle], 1.0, 1.01 * s.step[0]);
    slice_release(&s);
    free(u);
    free(p);
}

struct lines {
    int n, points;
    double first, spread; /* [m] radius at the start of a line; the largest
                             change along one */
};

static void add_point(void *of, const double *x)
{
    struct lines *const l = of;

    if (x == NULL) {
        l->n++;
        l->first = 0.0;
        return;
    }
    const double r = hypot(x[0] - 1.0, x[1] - 1.0);
    if (l->first == 0.0) l->first = r;
    l->points++;
    l->spread = fmax(l->spread, fabs(r - l->first));
}

/* By Euler's method a line of 300 steps would leave its circle by a tenth of a
 * metre; the midpoint rule leaves 1e-4 r. Beyond the last centres the field
 * does not rise any more, so lines there are left out. */
FACT(streamlines_of_a_fluid_that_turns_are_circles)
{
    double *u, *p;
    struct slice s = turning(2, &u, &p);
    struct lines l = {.n = 0};

    slice_streamlines(&s, 0.2, add_point, &l);
    ck_assert_int_ge(l.n, 4);
    ck_assert_int_ge(l.points, 400);
    ck_assert_double_lt(l.spread, 0.01);
    slice_release(&s);
    free(u);
    free(p);
}

/* --- surfaces ------------------------------------------------------------- */

/* A square that stands on the plane, one that lies in it and a triangle that is
 * cut at half its height. */
FACT(surfaces_are_cut_where_they_cross_the_plane)
{
    double x[] = {0, 0, -1, 0, 0, 1,  0, 1, 1, 0, 1, -1, /* stands */
                  0, 0, 5,  1, 0, 5,  1, 1, 5,           /* lies above */
                  2, 0, -1, 4, 0, -1, 3, 0, 1};
    int end[] = {4, 7, 10};
    const struct outline o = {
        .n_points = 10, .n_polygons = 3, .x = x, .end = end};
    char *text;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    outline_section(out, &o, (int[3]){0, 1, 2}, 0.0);
    fclose(out);
    ck_assert_str_eq(text, "0 0\n0 1\n\n3.5 0\n2.5 0\n\n");
    free(text);
}
