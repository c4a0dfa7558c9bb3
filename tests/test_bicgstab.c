/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"
#include "linear/faces.h"

#include "facts.h"
#include "linear_case.h"

#include <gsl/gsl_linalg.h>
#include <omp.h>

/* Convection (upwind, flux along every link) and diffusion, with a sink that
 * differs by component: three systems with common entries off the diagonal. */
struct setting {
    struct links b;
    struct csr *A; /* the same as rows, to compare with */
    struct faces faces;
    struct ldu *M;
    double *diag, *rhs, *x;
};

static struct setting convection(int nx, int ny, int nz, double flux)
{
    struct setting s = {.b = links_cube(nx, ny, nz)};
    const int n = s.b.n;

    s.A = diffusion(&s.b, NULL);
    for (int l = 0; l < s.b.n_links; l++) {
        s.A->a[s.A->lower[l]] -= flux; /* what comes from the owner */
        s.A->diag[s.b.owner[l]] += flux;
    }
    s.faces = (struct faces){.n_inner = s.b.n_links,
                             .n = s.b.n_links,
                             .n_cells = n,
                             .owner = s.b.owner,
                             .neighbour = s.b.neighbour};
    faces_divide(&s.faces);
    s.M = ldu_create(n, s.b.n_links, s.b.owner, s.b.neighbour, s.faces.pieces);
    for (int l = 0; l < s.b.n_links; l++) {
        s.M->upper[l] = s.A->a[s.A->upper[l]];
        s.M->lower[l] = s.A->a[s.A->lower[l]];
    }
    ldu_update(s.M);
    s.diag = alloc_doubles(3 * n);
    for (int i = 0; i < 3 * n; i++)
        s.diag[i] = s.A->diag[i / 3] + 0.2 + i % 3;
    s.rhs = noise_vector(3 * n, 1);
    s.x = alloc_doubles(3 * n);
    return s;
}

static void release(struct setting *s)
{
    free(s->diag);
    free(s->rhs);
    free(s->x);
    owner_free(s->A);
    owner_free(s->M);
    owner_free(s->faces.pieces);
    links_free(&s->b);
}

/* Its vectors are longer than they need to be. */
static struct bicgstab_work *work_create(int n, double *space[5])
{
    for (int k = 0; k < 5; k++)
        space[k] = alloc_doubles(4 * n);
    return bicgstab_work_lent(n, space);
}

static void work_free(struct bicgstab_work *w, double *space[5])
{
    for (int k = 0; k < 5; k++)
        free(space[k]);
    owner_free(w);
}

static struct solve_report solve(struct setting *s, double tolerance,
                                 double absolute, int limit)
{
    double *space[5];
    struct bicgstab_work *const w = work_create(s->b.n, space);
    const struct solve_report r = bicgstab_solve(s->M, s->diag, s->rhs, s->x,
                                                 tolerance, absolute, limit, w);

    work_free(w, space);
    return r;
}

/* |b - A x| of one component. */
static double residual(const struct setting *s, int k)
{
    double *const y = alloc_doubles(3 * s->b.n);
    double sum = 0.0;

    csr_rows_each(0, s->A->n, s->A, 3, s->diag, s->x, y);
    for (int i = k; i < 3 * s->b.n; i += 3)
        sum += (s->rhs[i] - y[i]) * (s->rhs[i] - y[i]);
    free(y);
    return sqrt(sum);
}

/* No eigenvalue is below 0.2, so the error is at most some 5 |r|, |r| some
 * 1e-12 |b| = 1e-11, and the matrix is close enough to normal for that. */
FACT(each_component_is_solved_as_by_elimination)
{
    struct setting s = convection(6, 5, 4, 3.0);
    const size_t n = (size_t)s.b.n;
    gsl_permutation *const p = gsl_permutation_alloc(n);
    gsl_vector *const x = gsl_vector_alloc(n);

    ck_assert(solve(&s, 1e-12, 0.0, 200).converged);
    for (size_t k = 0; k < 3; k++) {
        double *const D = dense_copy(s.A);
        gsl_matrix_view A = gsl_matrix_view_array(D, n, n);
        gsl_vector_view b = gsl_vector_view_array_with_stride(s.rhs + k, 3, n);
        int sign;

        for (size_t i = 0; i < n; i++)
            D[i * n + i] = s.diag[3 * i + k];
        gsl_linalg_LU_decomp(&A.matrix, p, &sign);
        gsl_linalg_LU_solve(&A.matrix, p, &b.vector, x);
        for (size_t i = 0; i < n; i++)
            ck_assert_double_eq_tol(s.x[3 * i + k], gsl_vector_get(x, i), 1e-9);
        free(D);
    }
    gsl_permutation_free(p);
    gsl_vector_free(x);
    release(&s);
}

/* The recurrence drifts from the true residual by rounding only. */
FACT(the_worst_true_residual_is_the_one_reported)
{
    struct setting s = convection(20, 20, 5, 1.0);
    const double scale = sqrt(dot_plain(3 * s.b.n, s.rhs, s.rhs));
    const struct solve_report r = solve(&s, 1e-8, 0.0, 200);
    double most = 0.0;

    for (int k = 0; k < 3; k++)
        most = fmax(most, residual(&s, k));
    ck_assert(r.converged);
    ck_assert_double_le(r.after, 1e-8);
    ck_assert_double_eq_tol(most / scale, r.after, 1e-13);
    release(&s);
}

FACT(a_good_guess_costs_nothing)
{
    struct setting s = convection(7, 7, 7, 2.0);
    double *const exact = noise_vector(3 * s.b.n, 5);

    csr_rows_each(0, s.A->n, s.A, 3, s.diag, exact, s.rhs);
    memcpy(s.x, exact, 3 * (size_t)s.b.n * sizeof *exact);

    const struct solve_report r = solve(&s, 1e-12, 0.0, 10);

    ck_assert(r.converged && r.iterations == 0);
    ck_assert_double_eq(r.after, r.before);
    ck_assert_mem_eq(s.x, exact, 3 * (size_t)s.b.n * sizeof *exact);
    free(exact);
    release(&s);
}

/* As in a flow that is almost two-dimensional. */
FACT(a_converged_component_is_not_changed_while_the_others_iterate)
{
    struct setting s = convection(12, 12, 12, 2.0);

    for (int i = 0; i < s.b.n; i++)
        s.rhs[3 * i + 2] = 0.0;
    for (int i = 0; i < s.b.n; i++)
        s.rhs[3 * i + 1] *= 1e-9;

    const struct solve_report r = solve(&s, 1e-6, 0.0, 100);

    ck_assert(r.converged && r.iterations > 2);
    for (int i = 0; i < s.b.n; i++) {
        ck_assert_double_eq(s.x[3 * i + 1], 0.0); /* below the tolerance */
        ck_assert_double_eq(s.x[3 * i + 2], 0.0);
    }
    release(&s);
}

FACT(without_a_right_hand_side_the_solution_is_zero)
{
    struct setting s = convection(3, 3, 3, 1.0);
    double *space[5];
    struct bicgstab_work *const w = work_create(27, space);

    bicgstab_solve(s.M, s.diag, s.rhs, s.x, 1e-6, 0.0, 1, w);
    ck_assert_double_gt(fabs(bicgstab_residual(w)[80]), 0.0);
    memset(s.rhs, 0, 81 * sizeof *s.rhs);
    s.x[7] = 1.0;

    const struct solve_report r =
        bicgstab_solve(s.M, s.diag, s.rhs, s.x, 1e-6, 0.0, 10, w);

    ck_assert(r.converged && r.iterations == 0);
    for (int i = 0; i < 81; i++) {
        ck_assert_double_eq(s.x[i], 0.0);
        ck_assert_double_eq(bicgstab_residual(w)[i], 0.0);
    }
    work_free(w, space);
    release(&s);
}

/* The squares of this residual are no normal numbers any more: an iteration
 * would divide what has lost its digits. */
FACT(a_residual_whose_square_underflows_counts_as_solved)
{
    struct setting s = convection(8, 8, 4, 0.5);

    for (int i = 0; i < 3 * s.b.n; i++)
        s.rhs[i] *= 1e-157;
    const struct solve_report r = solve(&s, 0.0, 0.0, 500);

    ck_assert_double_gt(r.before, 0.0);
    ck_assert(r.converged);
    ck_assert_int_eq(r.iterations, 0);
    release(&s);
}

/* A = (1 -3; 1 1) turns b = (1 1) into something square to it: no step can be
 * made from zero. From elsewhere the same system is solved: x = 1, y = 0. */
FACT(a_breakdown_is_reported)
{
    const int own = 0, nei = 1;
    struct ldu *const A = ldu_create(2, 1, &own, &nei, NULL);
    double *space[5];
    struct bicgstab_work *const w = work_create(2, space);
    const double b[6] = {1, 1, 1, 1, 1, 1}, diag[6] = {1, 1, 1, 1, 1, 1};
    double x[6] = {0};

    A->upper[0] = -3.0;
    A->lower[0] = 1.0;
    ldu_update(A);

    struct solve_report r = bicgstab_solve(A, diag, b, x, 1e-10, 0.0, 50, w);

    ck_assert(!r.converged && r.iterations == 1);
    ck_assert_double_eq_tol(r.after, sqrt(1.0 / 3.0), 1e-15);
    for (int k = 0; k < 6; k++)
        ck_assert_double_eq(x[k], 0.0);
    for (int k = 0; k < 3; k++)
        x[3 + k] = 0.2;
    r = bicgstab_solve(A, diag, b, x, 1e-10, 0.0, 50, w);
    ck_assert(r.converged);
    for (int k = 0; k < 3; k++) {
        ck_assert_double_eq_tol(x[k], 1.0, 1e-9);
        ck_assert_double_eq_tol(x[3 + k], 0.0, 1e-9);
    }
    work_free(w, space);
    owner_free(A);
}

/* By pieces, and by lists in a box of rows that are too short. */
FACT(one_diagonal_for_all_components_gives_the_bits_of_three_equal_ones)
{
    for (int width = 2; width <= 20; width += 18) {
        struct setting s = convection(width, 9, 7, 0.7);
        const int n = 3 * s.b.n;
        double *const three = alloc_doubles(n);

        for (int i = 0; i < n; i++)
            s.diag[i] = s.A->diag[i / 3] + 0.3 + i / 3 % 5;
        ck_assert(solve(&s, 1e-10, 0.0, 50).iterations > 2);
        memcpy(three, s.x, (size_t)n * sizeof *three);
        memset(s.x, 0, (size_t)n * sizeof *three);
        for (int i = 0; i < s.b.n; i++)
            s.diag[i] = s.diag[3 * i];
        s.M->diagonals = 1;
        solve(&s, 1e-10, 0.0, 50);
        ck_assert_mem_eq(s.x, three, (size_t)n * sizeof *three);
        free(three);
        release(&s);
    }
}

FACT(limits_and_numbers_that_are_none_are_reported)
{
    struct setting s = convection(12, 12, 12, 2.0);
    struct solve_report r = solve(&s, 1e-12, 0.0, 2);

    ck_assert(!r.converged && r.iterations == 2);
    ck_assert_double_gt(r.after, 1e-12);
    s.rhs[100] = NAN;
    r = solve(&s, 1e-12, 0.0, 50);
    ck_assert(!r.converged && r.iterations <= 1);
    s.rhs[100] = 1.0;
    memset(s.x, 0, 3 * (size_t)s.b.n * sizeof *s.x);
    ck_assert(solve(&s, 1e-6, 0.0, 50).converged);
    release(&s);
}

FACT(threads_do_not_change_a_bit)
{
    double *first = NULL;

    for (int threads = 1; threads <= 2; threads++) {
        struct setting s = convection(25, 24, 23, 2.0);
        const size_t size = 3 * (size_t)s.b.n * sizeof *s.x;

        omp_set_num_threads(threads);
        solve(&s, 1e-8, 0.0, 4);
        if (threads == 1)
            memcpy(first = alloc_doubles(3 * s.b.n), s.x, size);
        else
            ck_assert_mem_eq(first, s.x, size);
        release(&s);
    }
    free(first);
}

/* What the pressure writes between two solutions. */
FACT(what_is_lent_leaves_the_residual_and_the_next_solution)
{
    struct setting s = convection(9, 8, 7, 0.5);
    const int n = s.b.n;
    double *space[5];
    struct bicgstab_work *const w = work_create(n, space);
    double *const first = alloc_doubles(3 * n), *const r = alloc_doubles(3 * n);

    bicgstab_solve(s.M, s.diag, s.rhs, s.x, 1e-6, 0.0, 50, w);
    memcpy(first, s.x, 3 * (size_t)n * sizeof *first);
    memcpy(r, bicgstab_residual(w), 3 * (size_t)n * sizeof *r);
    for (int k = 1; k < 5; k++)
        for (int i = 0; i < 4 * n; i++)
            space[k][i] = 1e9;
    for (int i = 0; i < 3 * n; i++)
        ck_assert_double_eq(bicgstab_residual(w)[i], r[i]);
    memset(space[0], 1, 4 * (size_t)n * sizeof **space);
    memset(s.x, 0, 3 * (size_t)n * sizeof *s.x);
    bicgstab_solve(s.M, s.diag, s.rhs, s.x, 1e-6, 0.0, 50, w);
    for (int i = 0; i < 3 * n; i++)
        ck_assert_double_eq(s.x[i], first[i]);
    free(first);
    free(r);
    work_free(w, space);
    release(&s);
}
