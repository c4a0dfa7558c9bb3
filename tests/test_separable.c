/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/separable.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/diffusion.h"
#include "base/alloc.h"
#include "boxes.h"
#include "facts.h"
#include "cloud.h"
#include "linear/chebyshev.h"

/* The whole matrix of the mesh, without separation of directions. */
static struct csr *laplacian(const struct mesh *m)
{
    struct csr *const K =
        csr_create(m->n_cells, m->n_internal, m->owner, m->neighbour);

    for (int f = 0; f < m->n_internal; f++) {
        double SS = 0.0, Sd = 0.0;
        for (int k = 0; k < 3; k++) {
            SS += mesh_S(m, f)[k] * mesh_S(m, f)[k];
            Sd += mesh_S(m, f)[k] * mesh_d(m, f)[k];
        }
        K->a[K->upper[f]] -= SS / Sd;
        K->a[K->lower[f]] -= SS / Sd;
        K->diag[m->owner[f]] += SS / Sd;
        K->diag[m->neighbour[f]] += SS / Sd;
    }
    return K;
}

static struct mesh *shape(int i)
{
    return mesh_create_box(&cloud_shapes[i]);
}

static void smooth(const struct mesh *mesh, double b, double tail, int m,
                   double *u)
{
    struct separable *const s =
        separable_create(&mesh->box, diffusion_time(b), 0.0, tail);

    separable_apply(s, m, u);
    owner_free(s);
}

/* Every kind of box, bandwidths from a third of a cell to all of it: the same
 * as the series of the whole matrix, within what both leave away. */
FACT_FOR_EACH(by_directions_it_is_the_exponential_of_the_whole_matrix,
              9 * CLOUD_SHAPES)
{
    static const double b[] = {0.03, 0.2, 2.0}, tail[] = {1e-13, 1e-6, 1e-2};
    struct mesh *const mesh = shape(_i / 9);
    const int n = 5 * mesh->n_cells;
    double *const u = alloc_doubles(n), *const v = alloc_doubles(n);
    struct csr *const K = laplacian(mesh);
    struct chebyshev *const series =
        chebyshev_create(K, mesh->V, diffusion_time(b[_i / 3 % 3]), 1e-15, 5);

    cloud_numbers(3, n, u);
    memcpy(v, u, (size_t)n * sizeof *u);
    chebyshev_apply(series, 5, v);
    smooth(mesh, b[_i / 3 % 3], tail[_i % 3], 5, u);
    for (int i = 0; i < n; i++)
        ck_assert_double_eq_tol(u[i], v[i], tail[_i % 3]);
    owner_free(series);
    owner_free(K);
    mesh_free(mesh);
    free(u);
    free(v);
}

/* However much is left away: sums to rounding, constants, and no cell below
 * what the lowest had. */
FACT_FOR_EACH(the_sum_is_kept_and_nothing_undershoots_for_any_tail,
              CLOUD_SHAPES)
{
    static const double tail[] = {1e-12, 1e-3, 0.5};
    struct mesh *const mesh = shape(_i);
    const int n = mesh->n_cells;
    double *const u = alloc_doubles(3 * n);

    for (int k = 0; k < 3; k++) {
        double volume = 0.0, sum = 0.0, weighted = 0.0, wanted = 0.0;
        for (int c = 0; c < n; c++) {
            u[3 * c] = c == n / 2;
            u[3 * c + 1] = 1.0;
            u[3 * c + 2] = c % 5;
            volume += mesh->V[c];
            wanted += mesh->V[c] * (c % 5);
        }
        smooth(mesh, k == 0 ? 0.03 : 0.25, tail[k], 3, u);
        for (int c = 0; c < n; c++) {
            ck_assert_double_ge(u[3 * c], 0.0);
            ck_assert_double_eq_tol(u[3 * c + 1], 1.0, 1e-15);
            sum += mesh->V[c] * u[3 * c];
            weighted += mesh->V[c] * u[3 * c + 2];
        }
        ck_assert_double_eq_tol(sum / mesh->V[n / 2], 1.0, 1e-14);
        ck_assert_double_eq_tol(weighted, wanted, 1e-14 * volume);
    }
    free(u);
    mesh_free(mesh);
}

/* sum V a (E b) = sum V (E a) b, to rounding, however much is left away. */
FACT_FOR_EACH(it_is_its_own_adjoint, CLOUD_SHAPES)
{
    struct mesh *const mesh = shape(_i);
    const int n = mesh->n_cells;
    double *const u = alloc_doubles(2 * n), *const E = alloc_doubles(2 * n);
    double there = 0.0, back = 0.0, scale = 0.0;

    cloud_numbers(5, 2 * n, u);
    memcpy(E, u, (size_t)(2 * n) * sizeof *u);
    smooth(mesh, 0.3, 0.1, 2, E);
    for (int c = 0; c < n; c++) {
        there += mesh->V[c] * u[2 * c] * E[2 * c + 1];
        back += mesh->V[c] * E[2 * c] * u[2 * c + 1];
        scale += mesh->V[c];
    }
    ck_assert_double_eq_tol(there, back, 1e-15 * scale);
    free(u);
    free(E);
    mesh_free(mesh);
}

/* Fields are independent of each other and of the threads, however they are
 * bundled: the same bits. 33 fields do not fit into one bundle, or two. */
FACT_FOR_EACH(fields_and_threads_do_not_change_the_bits, 9)
{
    enum { MOST = 33 };
    static const int fewer[] = {1, 2, 3, 4, 7, 8, 16, 17, 32};
    const struct box_spec spec = {
        {1.1, 1.3, 0.9}, {11, 13, 9}, {2.0, 1.0, 1.0}, {0, 1, 0}};
    struct mesh *const mesh = mesh_create_box(&spec);
    const int n = mesh->n_cells, m = fewer[_i];
    double *const all = alloc_doubles(MOST * n), *const u =
                                                     alloc_doubles(m * n);

    cloud_numbers(9, MOST * n, all);
    for (int c = 0; c < n; c++)
        memcpy(&u[m * c], &all[MOST * c], (size_t)m * sizeof *u);
    omp_set_num_threads(1);
    smooth(mesh, 0.3, 1e-6, MOST, all);
    omp_set_num_threads(3);
    smooth(mesh, 0.3, 1e-6, m, u);
    omp_set_num_threads(1);
    for (int c = 0; c < n; c++)
        ck_assert_mem_eq(&u[m * c], &all[MOST * c], (size_t)m * sizeof *u);
    free(all);
    free(u);
    mesh_free(mesh);
}

/* Long enough, some milliseconds, for two threads to be at work at once. */
FACT(no_thread_packs_into_the_bundle_of_another)
{
    struct mesh *const mesh = closed_box(1.0, 1.0, 1.0, 40, 40, 40);
    const int n = 7 * mesh->n_cells;
    double *const one = alloc_doubles(n), *const two = alloc_doubles(n);

    cloud_numbers(9, n, one);
    memcpy(two, one, (size_t)n * sizeof *two);
    for (int k = 0; k < 5; k++) {
        omp_set_num_threads(1);
        smooth(mesh, 0.3, 1e-6, 7, one);
        omp_set_num_threads(2);
        smooth(mesh, 0.3, 1e-6, 7, two);
    }
    omp_set_num_threads(1);
    ck_assert_mem_eq(one, two, (size_t)n * sizeof *one);
    free(one);
    free(two);
    mesh_free(mesh);
}

/* In cells of d with b = 4 d, to 1e-6: the standard deviation is b / sqrt 2 =
 * 2.83 cells; a Gaussian has 1e-6 / 6 of itself beyond 5.23 of it, 15 cells.
 * That of a mesh falls a little more slowly. */
FACT(weights_go_as_far_as_a_gaussian_does)
{
    const struct box_spec spec = {
        {100.0, 20.0, 1.0}, {100, 20, 1}, {1.0, 1.0, 1.0}, {1, 0, 0}};
    struct mesh *const mesh = mesh_create_box(&spec);
    struct separable *const s =
        separable_create(&mesh->box, diffusion_time(4.0), 0.0, 1e-6);

    ck_assert_int_ge(separable_reach(s, 0), 15);
    ck_assert_int_le(separable_reach(s, 0), 17);
    ck_assert_int_eq(separable_reach(s, 2), 0);
    owner_free(s);
    mesh_free(mesh);
}

FACT(no_box_or_a_very_long_one_is_refused)
{
    const struct box none = {{0, 0, 0}, {0, 0, 0}, {NULL, NULL, NULL}};
    struct mesh *const mesh =
        closed_box(1.0, 1.0, 1.0, 1, SEPARABLE_MOST + 1, 1);

    ck_assert_ptr_null(separable_create(&none, 1.0, 0.0, 1e-6));
    ck_assert_ptr_null(separable_create(&mesh->box, 1.0, 0.0, 1e-6));
    mesh_free(mesh);
}
