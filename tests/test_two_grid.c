/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/averaging.h"

#include <math.h>

#include "boxes.h"
#include "facts.h"
#include "cloud.h"

/* n equal cells in a row of length 1; one particle; its amount of 1 averaged
 * with a second grid of cells of at least b. */
static void row(int n, double b, double x, double *field)
{
    const struct averaging_options o = {.bandwidth = b};
    struct mesh *const m = closed_box(1.0, 1.0, 1.0, n, 1, 1);
    struct particles *const ps = particles_create(1);
    const double q = 1.0;

    cloud_place(ps, x, 0.5, 0.5, 0.1);
    struct averaging *const a =
        averaging_create(averaging_method_named("two-grid"), m, ps, &o);
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 1, &q, field);
    averaging_free(a);
    particles_free(ps);
    mesh_free(m);
}

/* Three cells, two of the other grid: the first of these, which has density 2,
 * is all over cell 0 and half over cell 1. b = 0.4 has room for two. */
FACT(a_coarse_cell_gives_each_cell_what_is_common)
{
    double f[3];

    row(3, 0.4, 0.1, f);
    ck_assert_double_eq_tol(f[0], 2.0, 1e-14);
    ck_assert_double_eq_tol(f[1], 1.0, 1e-14);
    ck_assert_double_eq_tol(f[2], 0.0, 1e-14);
}

/* Wherever the particle is in its coarse cell. */
FACT(the_place_within_a_coarse_cell_does_not_matter)
{
    double f[8], g[8];

    row(8, 0.5, 0.01, f);
    row(8, 0.5, 0.49, g);
    for (int c = 0; c < 8; c++)
        ck_assert(f[c] == g[c]);
    ck_assert_double_eq_tol(f[3], 2.0, 1e-14);
}

/* b of a cell and of less than two: the grids are one. Of more than the mesh
 * has: one coarse cell, and all is even. */
FACT(with_the_width_of_a_cell_it_is_pcm)
{
    double f[8];

    for (int n = 1; n <= 8; n++) {
        row(n, 1.0 / n, 0.3, f);
        for (int c = 0; c < n; c++)
            ck_assert_double_eq_tol(f[c], c == (int)(0.3 * n) ? n : 0.0, 1e-13);
    }
    row(5, 7.0, 0.3, f);
    for (int c = 0; c < 5; c++)
        ck_assert_double_eq_tol(f[c], 1.0, 1e-14);
}

/* Coarse cells smaller than those of the mesh: it is pcm again but for cells
 * that lie across an edge. Four coarse cells, three of the mesh. */
FACT(a_second_grid_that_is_finer_loses_nothing)
{
    double f[3];

    row(3, 0.25, 0.3, f); /* the second of four, 0.25 .. 0.5 */
    ck_assert_double_eq_tol(f[0], 4.0 * (1.0 / 3.0 - 0.25) * 3.0, 1e-13);
    ck_assert_double_eq_tol(f[0] + f[1] + f[2], 3.0, 1e-13);
}
