/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/level_matrix.h"

#include "facts.h"
#include "linear_case.h"

/* Rounding of n = 20 pivots of order 1 to 8: below 1e-14. */
FACT(the_solution_satisfies_the_system)
{
    struct links b = links_cube(5, 4, 1);
    struct csr *const A = diffusion(&b, NULL);
    struct dense *const D = dense_create(20);
    double *const x = noise_vector(20, 1);

    add_wall(A, &b, NULL, (double[3]){1, 1, 1});

    double *const full = dense_copy(A), rhs[20];

    for (int i = 0; i < 20; i++)
        rhs[i] = dot_plain(20, full + 20 * i, x);
    memcpy(D->a, full, 400 * sizeof *full);
    dense_factor(D);
    dense_solve(D, rhs, rhs);
    for (int i = 0; i < 20; i++)
        ck_assert_double_eq_tol(rhs[i], x[i], 1e-13);
    free(full);
    free(x);
    owner_free(D);
    owner_free(A);
    links_free(&b);
}

/* Between walls of no flux, a constant may be added: the solver picks the
 * solution whose last unknown is zero, and divides by no noise. With twenty
 * sets of conductivities, noise leaves pivots of either sign. */
FACT(a_vanishing_pivot_leaves_its_unknown_at_zero)
{
    struct links b = links_cube(4, 3, 1);
    const double rhs[12] = {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1};
    struct dense *const D = dense_create(12);

    for (unsigned seed = 1; seed <= 20; seed++) {
        double *const k = noise_vector(12, seed), x[12];

        for (int i = 0; i < 12; i++)
            k[i] = exp(3.0 * k[i]);

        struct csr *const A = diffusion(&b, k);
        double *const full = dense_copy(A);

        memcpy(D->a, full, 144 * sizeof *full);
        dense_factor(D);
        dense_solve(D, rhs, x);
        ck_assert_double_eq(x[11], 0.0);
        for (int i = 0; i < 12; i++) /* rounding of terms of order 1000 */
            ck_assert_double_eq_tol(dot_plain(12, full + 12 * i, x), rhs[i],
                                    1e-11);
        free(full);
        free(k);
        owner_free(A);
    }
    owner_free(D);
    links_free(&b);
}
