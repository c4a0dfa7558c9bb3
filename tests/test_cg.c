/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"

#include "facts.h"
#include "linear_case.h"

#include <omp.h>

static const double unit[3] = {1, 1, 1};

struct setting {
    struct links b;
    struct csr *A;
    struct preconditioned M; /* the best preconditioner, with this matrix */
    struct cg_work *w;
    double *rhs, *x;
};

/* Diffusion in a box with one wall of value zero. */
static struct setting poisson(int nx, int ny, int nz)
{
    struct setting s = {.b = links_cube(nx, ny, nz)};

    s.A = diffusion(&s.b, NULL);
    add_wall(s.A, &s.b, NULL, unit);
    s.M = preconditioned_create(s.b.n, s.b.n_links, s.b.owner, s.b.neighbour,
                                s.b.strength, s.b.link, s.b.V);
    set_from(s.M, s.A);
    s.w = cg_work_create(s.b.n);
    s.rhs = noise_vector(s.b.n, 11);
    s.x = alloc_doubles(s.b.n);
    return s;
}

static struct preconditioned by_diagonal(const struct setting *s)
{
    return (struct preconditioned){&preconditioned_jacobi, s->A};
}

static void release(struct setting *s)
{
    free(s->rhs);
    free(s->x);
    owner_free(s->w);
    owner_free(s->M.matrix);
    owner_free(s->A);
    links_free(&s->b);
}

/* The residual of the recurrence drifts from the true one by rounding, some
 * 1e-15 an iteration times the condition of the product. */
FACT(the_true_residual_is_the_one_reported)
{
    for (int jacobi = 0; jacobi < 2; jacobi++) {
        struct setting s = poisson(16, 16, 16);
        const struct solve_report r = cg_solve(
            jacobi ? by_diagonal(&s) : s.M, s.rhs, s.x, 1e-10, 0.0, 1000, s.w);

        ck_assert(r.converged);
        ck_assert_double_eq_tol(r.before, 1.0, 1e-15);
        ck_assert_double_le(r.after, 1e-10);
        ck_assert_double_eq_tol(true_residual(s.A, s.rhs, s.x), r.after, 1e-13);
        release(&s);
    }
}

FACT(the_right_hand_side_may_be_the_third_vector_that_was_lent)
{
    struct setting s = poisson(8, 8, 8);
    double *const x = alloc_doubles(s.b.n), *space[3];

    for (int k = 0; k < 3; k++)
        space[k] = noise_vector(s.b.n, 11);
    struct cg_work *const lent = cg_work_lent(s.b.n, space);
    cg_solve(s.M, s.rhs, s.x, 1e-10, 0.0, 100, s.w);
    cg_solve(s.M, space[2], x, 1e-10, 0.0, 100, lent);
    for (int i = 0; i < s.b.n; i++)
        ck_assert_double_eq(x[i], s.x[i]);
    for (int k = 0; k < 3; k++)
        free(space[k]);
    free(x);
    owner_free(lent);
    release(&s);
}

/* One iteration more than needed would reduce it a hundredfold. */
FACT(the_residual_of_a_guess_is_reduced_as_asked)
{
    for (int jacobi = 0; jacobi < 2; jacobi++) {
        struct setting s = poisson(16, 16, 4);

        for (int i = 0; i < s.b.n; i++)
            s.x[i] = 1e3 * s.rhs[s.b.n - 1 - i];
        const struct solve_report r = cg_solve(jacobi ? by_diagonal(&s) : s.M,
                                               s.rhs, s.x, 1e-2, 0.0, 500, s.w);

        ck_assert(r.converged && r.before > 1e2);
        ck_assert_double_le(r.after, 1e-2 * r.before);
        ck_assert_double_gt(r.after, 1e-4 * r.before);
        release(&s);
    }
}

/* Without a tolerance the iteration goes on until the squares of the residual
 * are no normal numbers any more, below sqrt(DBL_MIN). */
FACT(a_residual_whose_square_underflows_counts_as_solved)
{
    for (int jacobi = 0; jacobi < 2; jacobi++) {
        struct setting s = poisson(8, 8, 4);

        double bb = 0.0;

        for (int i = 0; i < s.b.n; i++) {
            s.rhs[i] *= 1e-140;
            bb += s.rhs[i] * s.rhs[i];
        }
        const struct solve_report r = cg_solve(jacobi ? by_diagonal(&s) : s.M,
                                               s.rhs, s.x, 0.0, 0.0, 500, s.w);

        ck_assert(r.converged);
        ck_assert_int_lt(r.iterations, 500);
        ck_assert_double_le(r.after * sqrt(bb), 1.5e-154);
        release(&s);
    }
}

FACT(a_good_guess_costs_nothing)
{
    struct setting s = poisson(8, 8, 4);
    double *const exact = noise_vector(s.b.n, 4);

    csr_multiply(s.A, exact, s.rhs);
    memcpy(s.x, exact, (size_t)s.b.n * sizeof *exact);

    const double size = sqrt(dot_plain(s.b.n, s.rhs, s.rhs));
    const struct solve_report r =
        cg_solve(s.M, s.rhs, s.x, 0.0, 1e-12 * size, 10, s.w);

    ck_assert(r.converged && r.iterations == 0);
    ck_assert_mem_eq(s.x, exact, (size_t)s.b.n * sizeof *exact);
    free(exact);
    release(&s);
}

FACT(the_absolute_tolerance_stops_too)
{
    struct setting s = poisson(16, 16, 4);
    const double size = sqrt(dot_plain(s.b.n, s.rhs, s.rhs));
    const struct solve_report r =
        cg_solve(s.M, s.rhs, s.x, 0.0, 1e-3 * size, 100, s.w);

    ck_assert(r.converged);
    ck_assert_double_le(r.after, 1e-3);
    ck_assert_double_gt(r.after, 1e-6); /* no iterations beyond the tolerance */
    release(&s);
}

FACT(the_limit_of_iterations_is_reported)
{
    struct setting s = poisson(16, 16, 4);
    const struct solve_report r =
        cg_solve(by_diagonal(&s), s.rhs, s.x, 1e-10, 0.0, 3, s.w);

    ck_assert(!r.converged && r.iterations == 3);
    ck_assert_double_gt(r.after, 1e-10);
    ck_assert_double_eq_tol(true_residual(s.A, s.rhs, s.x), r.after, 1e-13);
    release(&s);
}

FACT(a_matrix_that_is_not_positive_is_reported)
{
    struct setting s = poisson(6, 6, 1);

    for (int i = 0; i < s.b.n; i++)
        s.A->diag[i] = 0.1;

    const struct solve_report r =
        cg_solve(by_diagonal(&s), s.rhs, s.x, 1e-10, 0.0, 100, s.w);

    ck_assert(!r.converged);
    ck_assert(isfinite(r.after));
    s.rhs[3] = NAN;
    ck_assert(
        !cg_solve(by_diagonal(&s), s.rhs, s.x, 1e-10, 0.0, 100, s.w).converged);
    release(&s);
}

FACT(threads_do_not_change_a_bit)
{
    struct setting s = poisson(33, 32, 31);
    double *const first = alloc_doubles(s.b.n);
    struct solve_report r[2];

    for (int threads = 1; threads <= 2; threads++) {
        omp_set_num_threads(threads);
        set_from(s.M, s.A);
        memset(s.x, 0, (size_t)s.b.n * sizeof *s.x);
        r[threads - 1] = cg_solve(s.M, s.rhs, s.x, 1e-8, 0.0, 3, s.w);
        if (threads == 1) memcpy(first, s.x, (size_t)s.b.n * sizeof *s.x);
    }
    ck_assert_mem_eq(first, s.x, (size_t)s.b.n * sizeof *s.x);
    ck_assert_double_eq(r[0].after, r[1].after);
    free(first);
    release(&s);
}
