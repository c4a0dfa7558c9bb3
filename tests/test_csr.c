/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/matrix.h"

#include "facts.h"
#include "linear_case.h"

#include <omp.h>

/* A matrix without symmetry on a periodic box of 2 x 3 x 1 cells: two links
 * join the same cells in x, and one joins a cell to itself in z. */
static struct csr *odd_matrix(struct links *b)
{
    unsigned seed = 7;

    *b = links_box(2, 3, 1, (double[3]){1, 1, 1}, (int[3]){1, 1, 1});

    struct csr *const A = csr_create(b->n, b->n_links, b->owner, b->neighbour);

    for (int l = 0; l < b->n_links; l++) {
        A->a[A->upper[l]] = noise(&seed);
        A->a[A->lower[l]] = noise(&seed);
    }
    for (int i = 0; i < A->n; i++)
        A->diag[i] = noise(&seed);
    return A;
}

FACT(every_entry_has_a_place_of_its_own)
{
    struct links b;
    struct csr *const A = odd_matrix(&b);
    int *const seen = alloc_ints(2 * b.n_links);

    for (int l = 0; l < b.n_links; l++) {
        ck_assert_int_eq(A->col[A->upper[l]], b.neighbour[l]);
        ck_assert_int_eq(A->col[A->lower[l]], b.owner[l]);
        ck_assert_int_ge(A->upper[l], A->start[b.owner[l]]);
        ck_assert_int_lt(A->upper[l], A->start[b.owner[l] + 1]);
        ck_assert_int_eq(seen[A->upper[l]]++, 0);
        ck_assert_int_eq(seen[A->lower[l]]++, 0);
    }
    free(seen);
    owner_free(A);
    links_free(&b);
}

FACT(columns_ascend_in_a_row)
{
    struct links b = links_cube(5, 4, 3);

    links_shuffle(&b, 3);

    struct csr *const A = csr_create(b.n, b.n_links, b.owner, b.neighbour);

    for (int i = 0; i < A->n; i++)
        for (int e = A->start[i] + 1; e < A->start[i + 1]; e++)
            ck_assert_int_lt(A->col[e - 1], A->col[e]);
    owner_free(A);
    links_free(&b);
}

/* Six terms a row: rounding is some 1e-16; a wrong entry is of order 1. */
FACT(product_is_that_of_the_full_matrix)
{
    struct links b;
    struct csr *const A = odd_matrix(&b);
    double *const D = dense_copy(A), *const x = noise_vector(A->n, 1);
    double *const y = alloc_doubles(A->n);

    csr_multiply(A, x, y);
    for (int i = 0; i < A->n; i++)
        ck_assert_double_eq_tol(y[i], dot_plain(A->n, D + i * A->n, x), 1e-14);
    free(D);
    free(x);
    free(y);
    owner_free(A);
    links_free(&b);
}

/* The sum of a row has the same order for one field and for many. */
FACT(fields_side_by_side_are_multiplied_as_each_alone)
{
    struct links b;
    struct csr *const A = odd_matrix(&b);

    for (int m = 1; m <= 16; m++) {
        double *const x = noise_vector(m * A->n, 5);
        double *const y = alloc_doubles(m * A->n);
        double *const x1 = alloc_doubles(A->n), *const y1 = alloc_doubles(A->n);

        csr_multiply_many(A, m, x, y);
        for (int k = 0; k < m; k++) {
            for (int i = 0; i < A->n; i++)
                x1[i] = x[m * i + k];
            csr_multiply(A, x1, y1);
            for (int i = 0; i < A->n; i++)
                ck_assert_double_eq(y[m * i + k], y1[i]);
        }
        free(x);
        free(y);
        free(x1);
        free(y1);
    }
    owner_free(A);
    links_free(&b);
}

FACT(each_field_may_have_its_own_diagonal)
{
    struct links b;
    struct csr *const A = odd_matrix(&b);

    for (int m = 2; m <= 3; m++) {
        double *const x = noise_vector(m * A->n, 5);
        double *const d = noise_vector(m * A->n, 6);
        double *const y = alloc_doubles(m * A->n);
        double *const z = alloc_doubles(m * A->n);

        csr_rows_each(0, A->n, A, m, d, x, y);
        csr_multiply_many(A, m, x, z);
        for (int i = 0; i < A->n; i++)
            for (int k = 0; k < m; k++) { /* rounding of two sums of order 1 */
                const double more = (d[m * i + k] - A->diag[i]) * x[m * i + k];

                ck_assert_double_eq_tol(y[m * i + k], z[m * i + k] + more,
                                        1e-14);
            }
        memset(d, 0, (size_t)(m * A->n) * sizeof *d);
        csr_rows_each(0, A->n, A, m, d, x, y);
        csr_rows_each(0, A->n, A, m, NULL, x, z); /* as with none but zeros */
        for (int i = 0; i < m * A->n; i++)
            ck_assert_double_eq(y[i], z[i]);
        free(x);
        free(d);
        free(y);
        free(z);
    }
    owner_free(A);
    links_free(&b);
}

/* A constant loses only what the row sums say: 1 where they are 1. */
FACT(a_matrix_of_diffusion_has_the_row_sums_that_were_given)
{
    struct links b =
        links_box(40, 20, 1, (double[3]){1, 2, 3}, (int[3]){1, 1, 1});
    struct csr *const A = csr_create(b.n, b.n_links, b.owner, b.neighbour);
    double *const one = alloc_doubles(b.n), *const y = alloc_doubles(b.n);
    double *const g = noise_vector(b.n_links, 1);

    for (int l = 0; l < b.n_links; l++)
        g[l] = 2.0 + g[l];
    for (int i = 0; i < b.n; i++)
        one[i] = 1.0;
    csr_set_diffusion(A, g, one);
    csr_multiply(A, one, y);
    for (int i = 0; i < b.n; i++)
        ck_assert_double_eq_tol(y[i], 1.0, 2e-14);
    owner_free(A);
    free(one);
    free(y);
    free(g);
    links_free(&b);
}

FACT(threads_do_not_change_a_bit)
{
    struct links b = links_cube(40, 30, 20);
    struct csr *const A = diffusion(&b, NULL);
    double *const x = noise_vector(3 * A->n, 2);
    double *const one = alloc_doubles(3 * A->n);
    double *const two = alloc_doubles(3 * A->n);

    omp_set_num_threads(1);
    csr_multiply_many(A, 3, x, one);
    omp_set_num_threads(2);
    csr_multiply_many(A, 3, x, two);
    ck_assert_mem_eq(one, two, 3 * (size_t)A->n * sizeof *one);
    free(x);
    free(one);
    free(two);
    owner_free(A);
    links_free(&b);
}
