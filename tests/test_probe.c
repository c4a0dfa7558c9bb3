/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/means/means.h"
#include "facts.h"

enum { CELLS = 6 * 9 * 5 };

/* Graded in all directions, so that no two widths agree. */
static struct mesh *graded_box(void)
{
    return mesh_create_box(&(struct box_spec){.size = {0.4, 1.2, 0.1},
                                              .cells = {6, 9, 5},
                                              .grading = {2.0, 0.3, 4.0}});
}

/* 1 + 2 x - 3 y + 5 z in the second of two components, rubbish in the first. */
static double at(const double x[3])
{
    return 1.0 + 2.0 * x[0] - 3.0 * x[1] + 5.0 * x[2];
}

static void fill(const struct mesh *m, double *f)
{
    for (int c = 0; c < m->n_cells; c++) {
        f[2 * c] = 1e9;
        f[2 * c + 1] = at(&m->centre[3 * c]);
    }
}

/* The tolerance is rounding of a sum of 8 terms of size 5. */
FACT(a_linear_field_is_interpolated_exactly_between_the_centres)
{
    static const double x[3][3] = {
        {0.11, 0.9, 0.05}, {0.2, 0.4, 0.06}, {0.3, 0.31, 0.031}};
    struct mesh *const m = graded_box();
    double f[2 * CELLS];

    fill(m, f);
    for (int i = 0; i < 3; i++) {
        const struct probe p = probe_at(m, x[i]);
        ck_assert_double_eq_tol(probe_value(&p, f, 2, 1, NULL), at(x[i]),
                                1e-14);
    }
    mesh_free(m);
}

FACT(beyond_the_last_centre_the_value_of_the_last_cell_is_used)
{
    static const double corner[2][3] = {{0.0, 0.0, 0.0}, {0.4, 1.2, 0.1}};
    static const int cell[2] = {0, CELLS - 1};
    struct mesh *const m = graded_box();
    double f[2 * CELLS];

    fill(m, f);
    for (int i = 0; i < 2; i++) {
        const struct probe p = probe_at(m, corner[i]);
        ck_assert_double_eq(probe_value(&p, f, 2, 1, NULL), f[2 * cell[i] + 1]);
    }
    mesh_free(m);
}

FACT(cells_without_weight_do_not_count)
{
    static const double x[3] = {0.11, 0.9, 0.05};
    struct mesh *const m = graded_box();
    const struct probe p = probe_at(m, x);
    double f[2 * CELLS], weight[CELLS] = {0.0};

    fill(m, f);
    ck_assert_double_eq(probe_value(&p, f, 2, 1, weight), 0.0);
    weight[p.cell[5]] = 0.25;
    /* share * 0.25 * f over share * 0.25: two roundings */
    ck_assert_double_eq_tol(probe_value(&p, f, 2, 1, weight),
                            f[2 * p.cell[5] + 1], 1e-15);
    mesh_free(m);
}
