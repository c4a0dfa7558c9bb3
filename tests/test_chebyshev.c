/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/chebyshev.h"

#include "facts.h"
#include "linear_case.h"

#include <gsl/gsl_eigen.h>
#include <omp.h>

/* Closed boxes whose cells have volumes of their own. */
struct setting {
    struct links b;
    struct csr *K;
};

static struct setting closed_box(int nx, int ny, int nz)
{
    struct setting s = {.b = links_cube(nx, ny, nz)};
    unsigned seed = 4;

    for (int i = 0; i < s.b.n; i++)
        s.b.V[i] = 1.0 + 0.6 * noise(&seed);
    s.K = diffusion(&s.b, NULL);
    return s;
}

static void release(struct setting *s)
{
    owner_free(s->K);
    links_free(&s->b);
}

static void diffuse(const struct setting *s, double T, double tail, int m,
                    double *u)
{
    struct chebyshev *const c = chebyshev_create(s->K, s->b.V, T, tail, m);

    chebyshev_apply(c, m, u);
    owner_free(c);
}

/* exp(-T V^-1 K) u by the eigenvectors q of V^-1/2 K V^-1/2. */
static void exact(const struct setting *s, double T, const double *u, double *x)
{
    const int n = s->b.n;
    const double *const V = s->b.V;
    double *const D = dense_copy(s->K);
    gsl_eigen_symmv_workspace *const work = gsl_eigen_symmv_alloc((size_t)n);
    gsl_vector *const lambda = gsl_vector_alloc((size_t)n);
    gsl_matrix *const q = gsl_matrix_alloc((size_t)n, (size_t)n);

    for (int i = 0; i < n * n; i++)
        D[i] /= sqrt(V[i / n] * V[i % n]);

    gsl_matrix_view view = gsl_matrix_view_array(D, (size_t)n, (size_t)n);

    gsl_eigen_symmv(&view.matrix, lambda, q, work);
    for (int i = 0; i < n; i++)
        x[i] = 0.0;
    for (size_t e = 0; e < (size_t)n; e++) {
        double share = 0.0;

        for (int i = 0; i < n; i++)
            share += gsl_matrix_get(q, (size_t)i, e) * sqrt(V[i]) * u[i];
        share *= exp(-T * gsl_vector_get(lambda, e));
        for (int i = 0; i < n; i++)
            x[i] += gsl_matrix_get(q, (size_t)i, e) * share / sqrt(V[i]);
    }
    gsl_eigen_symmv_free(work);
    gsl_vector_free(lambda);
    gsl_matrix_free(q);
    free(D);
}

/* The series leaves out less than tail and adds it to c_0: 2 tail of the norm
 * of u in V, here 5; the largest norm of an entry is 1/sqrt(V) < 1.6. */
FACT(the_series_is_the_exponential_up_to_its_tail)
{
    const double times[] = {0.0, 0.01, 1.0, 20.0, 500.0};
    const double tails[] = {1e-2, 1e-4, 1e-12};
    struct setting s = closed_box(5, 4, 3);
    double *const u = noise_vector(s.b.n, 3);
    double x[60], y[60];

    for (int t = 0; t < 5; t++)
        for (int e = 0; e < 3; e++) {
            exact(&s, times[t], u, x);
            memcpy(y, u, sizeof y);
            diffuse(&s, times[t], tails[e], 1, y);
            for (int i = 0; i < s.b.n; i++)
                ck_assert_double_eq_tol(x[i], y[i], 16.0 * tails[e]);
        }
    free(u);
    release(&s);
}

/* n = 3600 terms of order 1 and some 30 products: a few 1e-13 of the sum of
 * |V u|, some 2000. Without the shift of c_0 it would be the tail. */
FACT(mass_is_kept_to_rounding)
{
    struct setting s = closed_box(18, 50, 4);
    double *const u = noise_vector(s.b.n, 3);
    const double before = dot_plain(s.b.n, s.b.V, u);

    diffuse(&s, 4.0, 1e-3, 1, u);
    ck_assert_double_eq_tol(dot_plain(s.b.n, s.b.V, u), before, 1e-10);
    free(u);
    release(&s);
}

/* Every row of L adds up to zero, up to rounding. */
FACT(a_constant_stays)
{
    struct setting s = closed_box(9, 8, 7);
    double *const u = alloc_doubles(s.b.n);

    for (int i = 0; i < s.b.n; i++)
        u[i] = 1.0;
    diffuse(&s, 30.0, 1e-4, 1, u);
    for (int i = 0; i < s.b.n; i++)
        ck_assert_double_eq_tol(u[i], 1.0, 1e-12);
    free(u);
    release(&s);
}

/* From one full cell, the hardest case; the exponential itself is positive. */
FACT(an_undershoot_is_smaller_than_the_tail)
{
    const double times[] = {0.25, 1.0, 4.0, 16.0};
    struct setting s = closed_box(11, 11, 11);
    double *const u = alloc_doubles(s.b.n);

    for (int t = 0; t < 4; t++)
        for (double tail = 1e-6; tail < 1e-1; tail *= 10.0) {
            memset(u, 0, (size_t)s.b.n * sizeof *u);
            u[s.b.n / 2] = 1.0;
            diffuse(&s, times[t], tail, 1, u);
            for (int i = 0; i < s.b.n; i++)
                ck_assert_double_ge(u[i], -tail);
        }
    free(u);
    release(&s);
}

/* sum V v E u = sum V u E v: a polynomial of V^-1 K is, whatever its tail. */
FACT(the_series_is_its_own_adjoint_weighted_by_volume)
{
    struct setting s = closed_box(18, 20, 4);
    double *const u = noise_vector(s.b.n, 5), *const v = noise_vector(s.b.n, 6);
    double *const Eu = noise_vector(s.b.n, 5);
    double *const Ev = noise_vector(s.b.n, 6);

    diffuse(&s, 5.0, 1e-2, 1, Eu);
    diffuse(&s, 5.0, 1e-2, 1, Ev);
    for (int i = 0; i < s.b.n; i++)
        u[i] *= s.b.V[i], v[i] *= s.b.V[i];
    ck_assert_double_eq_tol(dot_plain(s.b.n, v, Eu), dot_plain(s.b.n, u, Ev),
                            1e-12); /* 1440 terms of order 0.1 */
    free(u);
    free(v);
    free(Eu);
    free(Ev);
    release(&s);
}

FACT(fields_side_by_side_diffuse_as_each_alone)
{
    struct setting s = closed_box(7, 6, 5);

    for (int m = 2; m <= 16; m++) {
        double *const u = noise_vector(m * s.b.n, 9);
        double *const one = alloc_doubles(m * s.b.n);
        struct chebyshev *const c = chebyshev_create(s.K, s.b.V, 3.0, 1e-5, m);

        for (int k = 0; k < m; k++) {
            double *const x = one + k * s.b.n;

            for (int i = 0; i < s.b.n; i++)
                x[i] = u[m * i + k];
            chebyshev_apply(c, 1, x); /* fewer than there is room for */
        }
        chebyshev_apply(c, m, u);
        for (int k = 0; k < m; k++)
            for (int i = 0; i < s.b.n; i++)
                ck_assert_double_eq(u[m * i + k], one[k * s.b.n + i]);
        free(u);
        free(one);
        owner_free(c);
    }
    release(&s);
}

/* The series of one field of m, term by term. */
static void plain(const struct chebyshev *s, int m, int f, double *u)
{
    const struct csr *const K = s->K;
    double *const y = alloc_doubles(K->n), *const next = alloc_doubles(K->n);
    double *const sum = alloc_doubles(K->n);

    for (int i = 0; i < K->n; i++)
        y[i] = u[m * i + f];
    for (int k = 1; k <= s->products; k++) {
        for (int i = 0; i < K->n; i++) {
            double Ly = K->diag[i] * y[i];

            for (int e = K->start[i]; e < K->start[i + 1]; e++)
                Ly += K->a[e] * y[K->col[e]];
            const double step = y[i] - Ly * s->factor[i];
            next[i] = k == 1 ? step : 2.0 * step - next[i];
            sum[i] = (k == 1 ? s->c[0] * y[i] : sum[i]) + s->c[k] * next[i];
        }
        for (int i = 0; i < K->n; i++) {
            const double before = y[i];
            y[i] = next[i];
            next[i] = before;
        }
    }
    for (int i = 0; i < K->n; i++)
        u[m * i + f] = sum[i];
    free(y);
    free(next);
    free(sum);
}

FACT(the_loop_by_groups_gives_the_bits_of_the_plain_one)
{
    struct setting s = closed_box(7, 6, 5);

    for (int m = 1; m <= 11; m++) {
        double *const u = noise_vector(m * s.b.n, 3);
        double *const v = noise_vector(m * s.b.n, 3);
        struct chebyshev *const c = chebyshev_create(s.K, s.b.V, 3.0, 1e-5, m);

        chebyshev_apply(c, m, u);
        for (int f = 0; f < m; f++)
            plain(c, m, f, v);
        for (int i = 0; i < m * s.b.n; i++)
            ck_assert_double_eq(u[i], v[i]);
        free(u);
        free(v);
        owner_free(c);
    }
    release(&s);
}

/* Some sqrt(z) products: z = lambda T, lambda about 12 here (cells of one). */
FACT(it_takes_about_as_many_products_as_the_root_of_z)
{
    struct setting s = closed_box(16, 16, 16);
    const int expected[][2] = {{8, 12}, {14, 20}, {28, 40}};
    double T = 1.0;

    for (int i = 0; i < s.b.n; i++)
        s.b.V[i] = 1.0;
    for (int t = 0; t < 3; t++, T *= 4.0) {
        struct chebyshev *const c = chebyshev_create(s.K, s.b.V, T, 1e-4, 1);

        ck_assert_int_ge(chebyshev_products(c), expected[t][0]);
        ck_assert_int_le(chebyshev_products(c), expected[t][1]);
        owner_free(c);
    }
    release(&s);
}

FACT(threads_do_not_change_a_bit)
{
    struct setting s = closed_box(20, 19, 18);
    double *const one = noise_vector(8 * s.b.n, 1);
    double *const two = noise_vector(8 * s.b.n, 1);

    omp_set_num_threads(1);
    diffuse(&s, 1.0, 1e-4, 8, one);
    omp_set_num_threads(2);
    diffuse(&s, 1.0, 1e-4, 8, two);
    ck_assert_mem_eq(one, two, 8 * (size_t)s.b.n * sizeof *one);
    free(one);
    free(two);
    release(&s);
}
