/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/bandwidth.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "base/alloc.h"
#include "facts.h"
#include "cloud.h"

/* n cells of 1 in a row between walls; particles of the given diameters in the
 * middles of the given cells. */
struct row {
    struct mesh *mesh;
    struct particles *ps;
    struct averaging *a;
    double field[200];
};

static struct row row_of(int n, double grading, int grains, const int *cell,
                         const double *d, const struct averaging_options *o)
{
    const struct box_spec spec = {
        {n, 1.0, 1.0}, {n, 1, 1}, {grading, 1.0, 1.0}, {0, 0, 0}};
    struct row r = {.mesh = mesh_create_box(&spec)};
    double q[200];

    r.ps = particles_create(grains);
    for (int i = 0; i < grains; i++) {
        cloud_place(r.ps, r.mesh->centre[3 * cell[i]], 0.5, 0.5, d[i]);
        q[i] = 1.0;
    }
    r.a =
        averaging_create(averaging_method_named("diffusion"), r.mesh, r.ps, o);
    ck_assert_ptr_nonnull(r.a);
    ck_assert_int_eq(averaging_bind(r.a), 0);
    averaging_spread(r.a, 1, q, r.field);
    return r;
}

static void row_free(struct row *r)
{
    averaging_free(r->a);
    particles_free(r->ps);
    mesh_free(r->mesh);
}

/* Mean square distance [m^2] from x of the field in the first to last cell. */
static double spread_around(const struct row *r, double x, int first, int last)
{
    double sum = 0.0, square = 0.0;

    for (int c = first; c < last; c++) {
        const double m = r->mesh->V[c] * r->field[c];
        sum += m;
        square += m * gsl_pow_2(r->mesh->centre[3 * c] - x);
    }
    return square / sum;
}

/* Along x the Gaussian has the mean square b^2 / 2, and the mesh keeps it. With
 * "cells", b^2 / 2 - 1/6, which the two times 1/12 of a cell of 1 make good: a
 * grain may be anywhere in its cell, and a value represents all of its cell. */
FACT(the_variance_of_the_cells_is_subtracted)
{
    const int cell = 50;
    const double d = 0.1;
    const struct averaging_options plain = {.bandwidth = 5.0,
                                            .tolerance = 1e-12};
    const struct averaging_options cells = {
        .bandwidth = 5.0, .vary = "cells", .tolerance = 1e-12};
    struct row a = row_of(101, 1.0, 1, &cell, &d, &plain);
    struct row b = row_of(101, 1.0, 1, &cell, &d, &cells);

    ck_assert_double_eq_tol(spread_around(&a, 50.5, 0, 101), 12.5, 1e-9);
    ck_assert_double_eq_tol(spread_around(&b, 50.5, 0, 101), 12.5 - 1.0 / 6.0,
                            1e-9);
    row_free(&a);
    row_free(&b);
}

/* Cells of 1, sqrt 3 b wide and a little more: nothing is left to diffuse. */
FACT(in_cells_too_large_it_is_pcm)
{
    const int cell = 5;
    const double d = 0.1;
    const struct averaging_options o = {.bandwidth = 0.57, .vary = "cells"};
    struct row r = row_of(11, 1.0, 1, &cell, &d, &o);

    for (int c = 0; c < 11; c++)
        ck_assert(r.field[c] == (c == cell ? 1.0 : 0.0));
    row_free(&r);
}

/* Left of x = 50 b is 4, right of it 2: mean squares of 8 and 2, as the blobs
 * are 6 b from the seam. Then a region of 0: a wall to either side. */
FACT(a_region_has_its_own_bandwidth)
{
    static const int cell[] = {25, 75};
    static const double d[] = {0.1, 0.1};
    struct averaging_region right = {
        {50.0, -1.0, -1.0}, {200.0, 2.0, 2.0}, 2.0};
    const struct averaging_options o = {
        .bandwidth = 4.0, .regions = {1, &right}, .tolerance = 1e-12};
    struct row r = row_of(100, 1.0, 2, cell, d, &o);

    ck_assert_double_eq_tol(spread_around(&r, 25.5, 0, 50), 8.0, 1e-6);
    ck_assert_double_eq_tol(spread_around(&r, 75.5, 50, 100), 2.0, 1e-6);
    row_free(&r);
    right.bandwidth = 0.0;
    r = row_of(100, 1.0, 2, cell, d, &o);
    for (int c = 50; c < 100; c++)
        ck_assert(r.field[c] == (c == 75 ? 1.0 : 0.0));
    row_free(&r);
}

/* Grains of 1 and 3 mm, as much volume of each: the mean diameter is 2 mm,
 * their bandwidths b / 2 and 3 b / 2. Only the cells with a grain differ in D
 * here, and so the test measures the flux out of these: after a short time each
 * has lost 2 T D, with D = 2 P / (P + 1) of the faces to empty cells. */
FACT(the_bandwidth_follows_the_diameter)
{
    int cell[28];
    double d[28];
    const double b = 0.02, T = b * b / 4.0;
    const struct averaging_options o = {
        .bandwidth = b, .vary = "grains", .tolerance = 1e-13};

    for (int i = 0; i < 28; i++) {
        cell[i] = i < 27 ? 25 : 75;
        d[i] = i < 27 ? 1e-3 : 3e-3;
    }
    struct row r = row_of(100, 1.0, 28, cell, d, &o);
    ck_assert_double_eq_tol((27.0 - r.field[25]) / 27.0 / (2.0 * T),
                            2.0 * 0.25 / 1.25, 1e-3);
    ck_assert_double_eq_tol((1.0 - r.field[75]) / (2.0 * T), 2.0 * 2.25 / 3.25,
                            1e-3);
    row_free(&r);
}

/* The same grains; the largest D is that of a cell with the larger ones alone,
 * times the largest of the regions. */
FACT_FOR_EACH(no_cell_has_more_than_the_largest_bandwidth, 2)
{
    static const struct averaging_region wide = {
        {50.0, 0.0, 0.0}, {60.0, 1.0, 1.0}, 0.06};
    int cell[28];
    double d[28];
    struct averaging_options o = {
        .bandwidth = 0.02, .vary = "grains", .tolerance = 1e-9};

    for (int i = 0; i < 28; i++) {
        cell[i] = i < 27 ? 25 : 75;
        d[i] = i < 27 ? 1e-3 : 3e-3;
    }
    struct row r = row_of(100, 1.0, 28, cell, d, &o);
    o.regions.item = &wide;
    o.regions.n = _i;
    struct bandwidth *const w = bandwidth_create(averaging_cells(r.a), &o);
    const double base = _i ? 9.0 : 1.0;
    ck_assert_double_eq_tol(bandwidth_largest(w), 2.25 * base, 1e-12);
    r.ps->n = 0;
    ck_assert_double_eq_tol(bandwidth_largest(w), base, 1e-12);
    owner_free(w);
    r.ps->n = 28;
    row_free(&r);
}

/* One size: the mean is a sum over the same numbers, equal to rounding. */
FACT(grains_of_one_size_have_one_bandwidth)
{
    int cell[60];
    double d[60];
    const struct averaging_options plain = {.bandwidth = 3.0,
                                            .tolerance = 1e-12};
    const struct averaging_options grains = {
        .bandwidth = 3.0, .vary = "grains", .tolerance = 1e-12};

    for (int i = 0; i < 60; i++) {
        cell[i] = i * i % 50;
        d[i] = 1e-3;
    }
    struct row a = row_of(50, 3.0, 60, cell, d, &plain);
    struct row b = row_of(50, 3.0, 60, cell, d, &grains);
    for (int c = 0; c < 50; c++)
        ck_assert_double_eq_tol(a.field[c], b.field[c], 1e-10);
    row_free(&a);
    row_free(&b);
}

/* A bed has grown larger grains since the series was made. */
FACT(a_grain_larger_than_all_before_is_averaged)
{
    static const int cell[] = {10, 20, 30};
    double d[] = {1e-3, 1e-3, 1e-3};
    const double q[] = {1.0, 1.0, 1.0};
    const struct averaging_options o = {
        .bandwidth = 3.0, .vary = "grains", .tolerance = 1e-9};
    struct row r = row_of(40, 1.0, 3, cell, d, &o);
    double sum = 0.0;

    r.ps->d[0] = 2e-3;
    ck_assert_int_eq(averaging_bind(r.a), 0);
    averaging_spread(r.a, 1, q, r.field);
    for (int c = 0; c < 40; c++) {
        ck_assert_double_ge(r.field[c], -1e-8);
        sum += r.mesh->V[c] * r.field[c];
    }
    ck_assert_double_eq_tol(sum, 3.0, 1e-12);
    row_free(&r);
}

/* A bed that is resumed does not know the grains that have left it. */
FACT(grains_that_are_gone_leave_no_trace)
{
    static const int cell[] = {10, 20, 30};
    static const double d[] = {1e-3, 1e-3, 1e-3};
    const double q[] = {1.0, 1.0, 1.0};
    const struct averaging_options o = {
        .bandwidth = 3.0, .vary = "grains", .tolerance = 1e-9};
    struct row fresh = row_of(40, 1.0, 3, cell, d, &o);
    struct row r = row_of(40, 1.0, 3, cell, d, &o);

    for (int i = 0; i < 2; i++) { /* in the second round as before */
        r.ps->d[0] = i == 0 ? 2e-3 : d[0];
        ck_assert_int_eq(averaging_bind(r.a), 0);
        averaging_spread(r.a, 1, q, r.field);
    }
    for (int c = 0; c < 40; c++)
        ck_assert(r.field[c] == fresh.field[c]);
    row_free(&r);
    row_free(&fresh);
}

/* What depends on the widths of cells alone goes by directions in a box, and is
 * what the series makes of all of it at once; some links of these boxes are too
 * long to be crossed. */
FACT_FOR_EACH(
    by_directions_the_variance_of_the_cells_is_subtracted_as_by_the_series,
    2 * CLOUD_SHAPES)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[_i / 2]);
    struct particles *const ps = cloud_create(m, 60);
    double *const field[2] = {alloc_doubles(m->n_cells),
                              alloc_doubles(m->n_cells)};
    double q[60];

    cloud_numbers(2, 60, q);
    for (int way = 0; way < 2; way++) {
        const struct averaging_options o = {.bandwidth = _i % 2 ? 0.3 : 0.07,
                                            .vary = "cells",
                                            .tolerance = 1e-12,
                                            .scheme = way == 0 ? "exponential"
                                                               : "series"};
        struct averaging *const a =
            averaging_create(averaging_method_named("diffusion"), m, ps, &o);
        ck_assert_int_eq(averaging_bind(a), 0);
        averaging_spread(a, 1, q, field[way]);
        if (way == 0) ck_assert_int_eq(averaging_report(a)->products, 0);
        averaging_free(a);
    }
    for (int c = 0; c < m->n_cells; c++)
        ck_assert_double_eq_tol(m->V[c] * field[0][c], m->V[c] * field[1][c],
                                1e-10);
    free(field[0]);
    free(field[1]);
    particles_free(ps);
    mesh_free(m);
}
