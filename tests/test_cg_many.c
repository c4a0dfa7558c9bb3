/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/solvers.h"

#include "facts.h"
#include "linear_case.h"

#include <omp.h>

/* An implicit step of diffusion in a closed box whose cells have volumes of
 * their own: A = V + K, b = V u, from the old field u. */
struct setting {
    struct links b;
    struct csr *A;
    int m;
    double *u, *rhs, *x;
};

static struct setting diffusion_step(int nx, int ny, int nz, int m)
{
    struct setting s = {.b = links_cube(nx, ny, nz), .m = m};
    const int n = s.b.n;
    unsigned seed = 2;

    for (int i = 0; i < n; i++)
        s.b.V[i] = 1.0 + 0.5 * noise(&seed);
    s.A = diffusion(&s.b, NULL);
    for (int i = 0; i < n; i++)
        s.A->diag[i] += s.b.V[i];
    s.u = alloc_doubles(m * n);
    s.rhs = alloc_doubles(m * n);
    s.x = alloc_doubles(m * n);
    for (int i = 0; i < m * n; i++) {
        s.u[i] = s.x[i] = (1 + i % m) * (0.3 + noise(&seed));
        s.rhs[i] = s.b.V[i / m] * s.u[i];
    }
    return s;
}

static void release(struct setting *s)
{
    free(s->u);
    free(s->rhs);
    free(s->x);
    owner_free(s->A);
    links_free(&s->b);
}

static struct solve_report solve(struct setting *s, const double *weight,
                                 double tolerance, int limit)
{
    struct cg_many_work *const w = cg_many_work_create(s->b.n, s->m);
    const struct solve_report r =
        cg_many_solve(s->A, weight, s->rhs, s->x, tolerance, 0.0, limit, w);

    owner_free(w);
    return r;
}

/* Both residuals are 1e-12, and no eigenvalue of A is below 0.5 (the least
 * volume), so the solutions agree to 2e-12 |b|, |b| some 100. */
FACT(each_field_is_solved_as_by_cg_alone)
{
    const int fields[] = {1, 3, 7, 8, 16};

    for (int f = 0; f < 5; f++) {
        struct setting s = diffusion_step(12, 9, 5, fields[f]);
        const int n = s.b.n, m = s.m;
        const struct solve_report r = solve(&s, NULL, 1e-12, 200);
        struct cg_work *const w = cg_work_create(n);
        double *const b = alloc_doubles(n), *const x = alloc_doubles(n);

        int most = 0;

        ck_assert(r.converged);
        for (int k = 0; k < m; k++) {
            for (int i = 0; i < n; i++)
                b[i] = s.rhs[m * i + k];
            for (int i = 0; i < n; i++)
                x[i] = s.u[m * i + k];

            const struct preconditioned A = {&preconditioned_jacobi, s.A};
            const double size = sqrt(dot_plain(n, b, b));
            const struct solve_report one =
                cg_solve(A, b, x, 0.0, 1e-12 * size, 200, w);

            most = one.iterations > most ? one.iterations : most;
            for (int i = 0; i < n; i++)
                ck_assert_double_eq_tol(s.x[m * i + k], x[i], 1e-9);
        }
        ck_assert_int_ge(r.iterations, most);
        ck_assert_int_le(r.iterations, most + 1);
        free(b);
        free(x);
        owner_free(w);
        release(&s);
    }
}

static double mass(const struct setting *s, const double *x, int k)
{
    double sum = 0.0;

    for (int i = 0; i < s->b.n; i++)
        sum += s->b.V[i] * x[s->m * i + k];
    return sum;
}

/* Rounding: n = 3600 terms of order k, a few 1e-12. By the diagonal instead
 * of V the mass errs as the solution does: 1e-3 of it for this tolerance. */
FACT(preconditioned_by_volume_mass_is_kept_to_rounding)
{
    struct setting s = diffusion_step(18, 50, 4, 7);
    const struct solve_report r = solve(&s, s.b.V, 1e-2, 100);

    ck_assert(r.converged && r.iterations > 1);
    for (int k = 0; k < s.m; k++)
        ck_assert_double_eq_tol(mass(&s, s.x, k), mass(&s, s.u, k), 1e-10);
    release(&s);
}

FACT(a_field_without_right_hand_side_becomes_zero)
{
    struct setting s = diffusion_step(5, 5, 5, 3);

    for (int i = 0; i < s.b.n; i++)
        s.rhs[3 * i + 1] = 0.0;

    const struct solve_report r = solve(&s, s.b.V, 1e-10, 200);

    ck_assert(r.converged);
    for (int i = 0; i < s.b.n; i++) {
        ck_assert_double_eq(s.x[3 * i + 1], 0.0);
        ck_assert(isfinite(s.x[3 * i]) && isfinite(s.x[3 * i + 2]));
    }
    release(&s);
}

/* Without a tolerance the iteration goes on until the squares of the residual
 * are no normal numbers any more, below sqrt(DBL_MIN). */
FACT(a_residual_whose_square_underflows_counts_as_solved)
{
    struct setting s = diffusion_step(8, 8, 4, 3);
    double most = 0.0;

    for (int i = 0; i < 3 * s.b.n; i++) {
        s.rhs[i] *= 1e-140;
        s.x[i] = 0.0;
    }
    for (int k = 0; k < 3; k++) {
        double bb = 0.0;
        for (int i = k; i < 3 * s.b.n; i += 3)
            bb += s.rhs[i] * s.rhs[i];
        most = fmax(most, sqrt(bb));
    }
    const struct solve_report r = solve(&s, NULL, 0.0, 500);

    ck_assert(r.converged);
    ck_assert_int_lt(r.iterations, 500);
    ck_assert_double_le(r.after * most, 3.0 * 1.5e-154);
    release(&s);
}

FACT(the_report_is_that_of_the_worst_field)
{
    struct setting s = diffusion_step(20, 20, 1, 2);

    for (int i = 0; i < s.b.n; i++) { /* field 0 is constant: solved */
        s.x[2 * i] = 1.0;
        s.rhs[2 * i] = s.b.V[i];
        s.x[2 * i + 1] = 0.0;
    }

    const struct solve_report r = solve(&s, s.b.V, 1e-12, 2);

    ck_assert(!r.converged && r.iterations == 2);
    ck_assert_double_eq_tol(r.before, 1.0, 1e-14);
    ck_assert_double_gt(r.after, 1e-12);
    for (int i = 0; i < s.b.n; i++) /* rounding of a row times two steps */
        ck_assert_double_eq_tol(s.x[2 * i], 1.0, 1e-14);
    release(&s);
}

FACT(a_number_that_is_none_is_reported)
{
    struct setting s = diffusion_step(4, 4, 4, 3);

    s.rhs[10] = NAN;

    const struct solve_report r = solve(&s, NULL, 1e-6, 50);

    ck_assert(!r.converged && isnan(r.after));
    release(&s);
}

FACT(threads_do_not_change_a_bit)
{
    double *first = NULL;

    for (int threads = 1; threads <= 2; threads++) {
        struct setting s = diffusion_step(20, 19, 18, 8);
        const size_t size = 8 * (size_t)s.b.n * sizeof *s.x;

        omp_set_num_threads(threads);
        solve(&s, s.b.V, 1e-8, 4);
        if (threads == 1)
            memcpy(first = alloc_doubles(8 * s.b.n), s.x, size);
        else
            ck_assert_mem_eq(first, s.x, size);
        release(&s);
    }
    free(first);
}
