/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/overlap.h"

#include <gsl/gsl_math.h>

#include "cloud.h"
#include "facts.h"

static const double ball = 4.0 / 3.0 * M_PI;

FACT(an_eighth_a_quarter_a_half_and_all_of_a_ball)
{
    ck_assert_double_eq_tol(overlap_octant(0, 0, 0), ball / 8.0, 1e-15);
    ck_assert_double_eq_tol(overlap_octant(-1, 0, 0), ball / 4.0, 1e-15);
    ck_assert_double_eq_tol(overlap_octant(-2, 0, -1), ball / 2.0, 1e-15);
    ck_assert_double_eq_tol(overlap_octant(-1, -1, -1), ball, 1e-15);
    ck_assert(overlap_octant(1, 0, 0) == 0.0);
    ck_assert(overlap_octant(0.6, 0.6, 0.6) == 0.0); /* corner outside */
}

/* A cap of height h is pi h^2 (3 - h) / 3. */
FACT(a_plane_cuts_off_a_cap)
{
    for (double a = -0.9; a < 1.0; a += 0.3) {
        const double h = 1.0 - a;
        ck_assert_double_eq_tol(overlap_octant(-3, a, -3),
                                M_PI / 3.0 * h * h * (3.0 - h), 1e-14);
    }
}

/* Sum over columns of width 1/1000, each with its length in z: the error is
 * that of a midpoint rule with a root at its ends, about 1e-5. */
static double by_columns(double a, double b, double c)
{
    enum { N = 1000 };
    const double h = 1.0 / N;
    double sum = 0.0;

    for (int i = (int)floor(fmax(a, -1.0) * N); i < N; i++)
        for (int j = (int)floor(fmax(b, -1.0) * N); j < N; j++) {
            const double x = (i + 0.5) * h, y = (j + 0.5) * h;
            const double z2 = 1.0 - x * x - y * y;
            if (z2 <= 0.0) continue;
            sum += fmax(0.0, sqrt(z2) - fmax(c, -sqrt(z2)));
        }
    return sum * h * h;
}

FACT_FOR_EACH(the_closed_form_is_the_integral, 8)
{
    static const double at[][3] = {{0.1, 0.2, 0.3},    {0.5, 0.5, 0.5},
                                   {-0.4, 0.3, 0.6},   {-0.2, -0.7, 0.1},
                                   {-0.5, -0.5, -0.5}, {0.05, -0.9, 0.2},
                                   {0.7, 0.69, 0.1},   {0.9, -0.1, -0.3}};
    const double *const p = at[_i];

    ck_assert_double_eq_tol(overlap_octant(p[0], p[1], p[2]),
                            by_columns(p[0], p[1], p[2]), 3e-5);
}

/* The order of the three planes does not matter. */
FACT(the_axes_are_alike)
{
    uint64_t state = 5;

    for (int n = 0; n < 200; n++) {
        const double a = 2.0 * cloud_random(&state) - 1.0;
        const double b = 2.0 * cloud_random(&state) - 1.0;
        const double c = 2.0 * cloud_random(&state) - 1.0;
        const double v = overlap_octant(a, b, c);
        ck_assert_double_eq_tol(overlap_octant(b, c, a), v, 1e-14);
        ck_assert_double_eq_tol(overlap_octant(b, a, c), v, 1e-14);
    }
}

/* Planes anywhere cut space into boxes: their parts add up to the ball, and no
 * part is negative or more than its box. Also with planes just touching the
 * ball, through its centre, and boxes much smaller than the ball. */
FACT_FOR_EACH(the_parts_of_a_ball_in_boxes_add_up_to_it, 24)
{
    static const double radius[] = {0.3, 0.5, 1.0, 2.5};
    const double R = radius[_i % 4];
    double edge[3][9], sum = 0.0, cube = 0.0;
    uint64_t state = 100 + (uint64_t)_i;

    for (int k = 0; k < 3; k++) {
        edge[k][0] = -3.0;
        edge[k][8] = 3.0;
        for (int e = 1; e < 8; e++)
            edge[k][e] = -1.2 + 0.3 * e + 0.3 * cloud_random(&state);
        edge[k][4] = _i % 3 == 0 ? 0.0 : edge[k][4];
    }
    edge[0][7] = fmax(edge[0][6], R); /* touches */
    for (int e = 0; e < 512; e++) {
        const int i = e % 8, j = e / 8 % 8, k = e / 64;
        const double lo[3] = {edge[0][i], edge[1][j], edge[2][k]};
        const double hi[3] = {edge[0][i + 1], edge[1][j + 1], edge[2][k + 1]};
        const double v = overlap_sphere(R, lo, hi);
        const double box = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
        ck_assert_double_ge(v, 0.0);
        ck_assert_double_le(v, box + 1e-13);
        ck_assert_double_le(v, overlap_cube(R, lo, hi) + 1e-13);
        sum += v;
        cube += overlap_cube(R, lo, hi);
    }
    ck_assert_double_eq_tol(sum, ball * R * R * R, 1e-12);
    ck_assert_double_eq_tol(cube, 8.0 * R * R * R, 1e-12);
}

/* A ball cut by all cells at once is that cut by each: cells of random widths,
 * wholly inside, beside, across; planes found by two sums that round. More
 * planes than the grid can hold are refused. */
FACT_FOR_EACH(corners_that_cells_share_are_found_once, 8)
{
    struct overlap_grid g;
    double edge[3][9];
    uint64_t state = 30 + (uint64_t)_i;

    for (int k = 0; k < 3; k++)
        for (int e = 0; e < 9; e++)
            edge[k][e] =
                e == 0 ? -3.0
                       : edge[k][e - 1] + (e == 8 ? 3.0 : cloud_random(&state));
    for (int pass = 0; pass < 2; pass++) {
        if (pass == 0) overlap_grid_start(&g, 1.2);
        for (int e = 0; e < 512; e++) {
            const int at[3] = {e % 8, e / 8 % 8, e / 64};
            double lo[3], hi[3];
            for (int k = 0; k < 3; k++) {
                lo[k] = edge[k][at[k]] * (1.0 + 1e-15);
                hi[k] = edge[k][at[k] + 1];
            }
            if (pass == 0)
                ck_assert_int_eq(overlap_grid_add(&g, lo, hi), 1);
            else
                ck_assert_double_eq_tol(overlap_grid_cell(&g, lo, hi),
                                        overlap_sphere(1.2, lo, hi), 1e-14);
        }
        if (pass == 0) overlap_grid_prepare(&g);
    }
    overlap_grid_start(&g, 1.0);
    for (int i = 0; i <= OVERLAP_PLANES; i++) {
        const double x = -0.9 + 0.1 * i;
        const double lo[3] = {x, -2.0, -2.0}, hi[3] = {2.0, 2.0, 2.0};
        ck_assert_int_eq(overlap_grid_add(&g, lo, hi), i < OVERLAP_PLANES);
    }
}
