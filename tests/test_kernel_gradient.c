/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/kernel_gradient.h"
#include "base/vector.h"

#include <gsl/gsl_math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"

/* Largest error of the gradient of sin(2 pi x) cos(2 pi y) in a box of n cells
 * a side, periodic or not, with b of 0.08: over 2 pi. */
static double wave_error(int n, double b, int periodic, double from, double to)
{
    const struct box_spec spec = {
        {1.0, 1.0, 0.1}, {n, n, 1}, {1.0, 1.0, 1.0}, {periodic, periodic, 1}};
    struct mesh *const m = mesh_create_box(&spec);
    struct particles *const ps = particles_create(40);
    double *const f = alloc_doubles(m->n_cells);
    double X[120], worst = 0.0;
    uint64_t state = 9;

    for (int i = 0; i < 40; i++) {
        const double x = from + (to - from) * cloud_random(&state);
        cloud_place(ps, x, 0.3 + 0.4 * cloud_random(&state), 0.05, 0.01);
    }
    for (int c = 0; c < m->n_cells; c++)
        f[c] = sin(2.0 * M_PI * m->centre[3 * c]) *
               cos(2.0 * M_PI * m->centre[3 * c + 1]);
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);
    ck_assert_int_eq(cell_of_particle_find(h), 0);
    struct kernel_gradient *const s = kernel_gradient_create(h, b);
    kernel_gradient_find(s, 1, f, X);
    for (int i = 0; i < 40; i++) {
        const double x = 2.0 * M_PI * ps->x[i], y = 2.0 * M_PI * ps->y[i];
        worst = fmax(worst, fabs(X[3 * i] / (2.0 * M_PI) - cos(x) * cos(y)));
        worst =
            fmax(worst, fabs(X[3 * i + 1] / (2.0 * M_PI) + sin(x) * sin(y)));
        ck_assert(X[3 * i + 2] == 0.0); /* one cell */
    }
    kernel_gradient_free(s);
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
    free(f);
    return worst;
}

/* b halves, and the cells with it: a quarter of the error. */
FACT(ew18_b_8_inside_the_gradient_is_of_second_order)
{
    const double e1 = wave_error(24, 0.08, 1, 0.0, 1.0);
    const double e2 = wave_error(48, 0.04, 1, 0.0, 1.0);
    ck_assert_double_eq_tol(log2(e1 / e2), 2.0, 0.15);
}

/* Next to a wall, within b / 2 of it: of first order, and larger. */
FACT(ew18_b_6_at_a_wall_it_is_of_first_order)
{
    const double e1 = wave_error(24, 0.08, 0, 0.0, 0.04);
    const double e2 = wave_error(48, 0.04, 0, 0.0, 0.02);
    ck_assert_double_lt(log2(e1 / e2), 1.5);
    ck_assert_double_gt(e1, wave_error(24, 0.08, 1, 0.0, 1.0));
}

/* One direction, equal cells, a plane, a particle in the middle of a cell: all
 * is symmetric, and the slope exact; [EW18 B.7] is then the whole system. With
 * two fields, and none in the directions of one cell. */
FACT(ew18_b_7_a_plane_has_its_slope_in_the_middle_of_a_row)
{
    struct mesh *const m = closed_box(3.0, 0.1, 0.1, 30, 1, 1);
    struct particles *const ps = particles_create(1);
    double f[60], X[6];

    cloud_place(ps, m->centre[3 * 15], 0.02, 0.07, 0.01);
    for (int c = 0; c < 30; c++) {
        f[2 * c] = 3.0 - 0.7 * m->centre[3 * c];
        f[2 * c + 1] = 5.0;
    }
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);
    ck_assert_int_eq(cell_of_particle_find(h), 0);
    struct kernel_gradient *const s = kernel_gradient_create(h, 0.25);
    kernel_gradient_find(s, 2, f, X);
    ck_assert_double_eq_tol(X[0], -0.7, 1e-12);
    ck_assert_double_eq_tol(
        kernel_gradient_row(0.1, 0.25, 0.0, 0.07, 0.0, -0.07), -0.7, 1e-14);
    for (int j = 1; j < 6; j++)
        ck_assert_double_eq_tol(X[j], 0.0, 1e-12);
    kernel_gradient_free(s);
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
}

/* On walls, in corners, in graded cells: where the kernel is cut off the sum of
 * r W is not 0, and only the difference to the mean makes it so. */
FACT_FOR_EACH(ew18_b_10_a_constant_has_no_slope_anywhere, CLOUD_SHAPES)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[_i]);
    struct particles *const ps = cloud_create(m, 60);
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);
    double *const f = alloc_doubles(m->n_cells);
    double X[180];

    for (int c = 0; c < m->n_cells; c++)
        f[c] = 5.0;
    ck_assert_int_eq(cell_of_particle_find(h), 0);
    struct kernel_gradient *const s = kernel_gradient_create(h, 0.15);
    kernel_gradient_find(s, 1, f, X);
    for (int j = 0; j < 180; j++)
        ck_assert_double_eq_tol(X[j], 0.0, 1e-11);
    kernel_gradient_free(s);
    free(f);
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
}

/* A random sum of squares times a known vector; then without a direction. */
FACT(ew18_b_8_the_small_system_is_solved)
{
    double A[6] = {0.0}, x[3];
    const double known[3] = {1.0, -2.0, 0.5};
    uint64_t state = 4;

    for (int n = 0; n < 5; n++) {
        const double a = cloud_random(&state), b = cloud_random(&state),
                     c = cloud_random(&state);
        const double rr[6] = {a * a, a * b, a * c, b * b, b * c, c * c};
        for (int j = 0; j < 6; j++)
            A[j] += rr[j];
    }
    const double b[3] = {A[0] * known[0] + A[1] * known[1] + A[2] * known[2],
                         A[1] * known[0] + A[3] * known[1] + A[4] * known[2],
                         A[2] * known[0] + A[4] * known[1] + A[5] * known[2]};
    vector_solve(A, b, x);
    for (int j = 0; j < 3; j++)
        ck_assert_double_eq_tol(x[j], known[j], 1e-11);
    const double flat[6] = {2.0, 0.0, 0.0, 0.0, 0.0, 4.0};
    const double c[3] = {1.0, 0.0, 1.0};
    vector_solve(flat, c, x);
    ck_assert(x[0] == 0.5 && x[1] == 0.0 && x[2] == 0.25);
}
