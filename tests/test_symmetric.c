/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/level_matrix.h"

#include <omp.h>

#include "facts.h"
#include "linear_case.h"

static const double unit[3] = {1, 1, 1};

/* Boxes whose links are all in bands, partly, not at all; with two links
 * between the same cells; with links of a cell to itself. */
enum { BOXES = 7 };
static struct links box(int which)
{
    switch (which) {
    case 0:
        return links_cube(13, 11, 9);
    case 1:
        return links_box(13, 11, 9, unit, (int[3]){1, 1, 1});
    case 2:
        return links_box(2, 2, 2, unit, (int[3]){1, 1, 1});
    case 3:
        return links_box(40, 1, 1, unit, (int[3]){1, 1, 1});
    case 4:
        return links_cube(1, 1, 1);
    case 5: /* six distances */
        return links_box(5, 5, 5, unit, (int[3]){1, 1, 1});
    default: {
        struct links b = links_box(13, 11, 9, unit, (int[3]){0, 1, 0});

        links_shuffle(&b, 9);
        return b;
    }
    }
}

struct setting {
    struct links b;
    struct csr *A;
    struct symmetric *S;
};

/* The same matrix twice, with conductivities of their own in every cell. */
static struct setting both(int which)
{
    struct setting s = {.b = box(which)};
    double *const k = noise_vector(s.b.n, 3);
    double *const g = alloc_doubles(s.b.n_links);
    double *const sums = alloc_doubles(s.b.n);

    for (int i = 0; i < s.b.n; i++)
        k[i] = 1.5 + k[i];
    s.A = diffusion(&s.b, k);
    for (int i = 0; i < s.b.n; i++)
        s.A->diag[i] += sums[i] = 0.1 * (i % 3);
    for (int l = 0; l < s.b.n_links; l++)
        g[l] = -s.A->a[s.A->upper[l]];
    s.S = symmetric_create(s.b.n, s.b.n_links, s.b.owner, s.b.neighbour, 1);
    symmetric_fill(s.S, g, sums, 0.25);
    free(k);
    free(g);
    free(sums);
    return s;
}

static void release(struct setting *s)
{
    owner_free(s->A);
    owner_free(s->S);
    links_free(&s->b);
}

FACT(a_box_needs_no_list_of_columns)
{
    struct setting s = both(0);

    ck_assert_ptr_null(s.S->rest);
    release(&s);
}

/* Seven terms of order 10, added in another order: some 1e-15. */
FACT(the_product_is_that_of_the_csr)
{
    for (int which = 0; which < BOXES; which++) {
        struct setting s = both(which);
        double *const x = noise_vector(s.b.n, 1);
        double *const y = alloc_doubles(s.b.n), *const z = alloc_doubles(s.b.n);
        const double xy = symmetric_multiply(s.S, x, y);

        csr_multiply(s.A, x, z);
        for (int i = 0; i < s.b.n; i++)
            ck_assert_double_eq_tol(y[i], z[i], 2e-14);
        ck_assert_double_eq_tol(xy, dot_plain(s.b.n, x, z), 1e-11);
        free(x);
        free(y);
        free(z);
        release(&s);
    }
}

/* Single precision: 6e-8 of terms of order 10 x 0.25. */
FACT(residual_and_relaxation_are_their_formulas)
{
    for (int which = 0; which < BOXES; which++) {
        struct setting s = both(which);
        const int n = s.b.n;
        float *const x = symmetric_vector(s.S), *const y =
                                                    symmetric_vector(s.S);
        float *const w = symmetric_vector(s.S), *const b =
                                                    symmetric_vector(s.S);
        double *const xd = noise_vector(n, 1), *const Ax = alloc_doubles(n);

        for (int i = 0; i < n; i++)
            x[i] = (float)xd[i];
        for (int i = 0; i < n; i++)
            b[i] = w[i] = (float)(1 + i % 4);
        csr_multiply(s.A, xd, Ax);
        symmetric_residual(s.S, b, x, y);
        for (int i = 0; i < n; i++)
            ck_assert_double_eq_tol(y[i], b[i] - 0.25 * Ax[i], 2e-6);
        symmetric_relax(s.S, b, x, 2.0F, w, 3.0F, 4.0F, w);
        for (int i = 0; i < n; i++) {
            const double per_d = s.S->inverse[i], r = b[i] - 0.25 * Ax[i];
            const double more = 4.0 * per_d * r;

            ck_assert_double_eq_tol(w[i], 2.0 * xd[i] + 3.0 * b[i] + more,
                                    2e-5);
        }
        free(xd);
        free(Ax);
        release(&s);
    }
}

/* The same numbers, to the bit, by any number of threads. */
FACT_FOR_EACH(all_stages_in_one_pass_are_stage_by_stage, 4)
{
    const struct level_smoothing w = {0.8F, 0.1F, 0.6F};
    struct links b = links_cube(40, 36, 32);
    const int n = b.n;
    double *const g = noise_vector(b.n_links, 3), *const sums =
                                                      alloc_doubles(n);
    struct symmetric *const S =
        symmetric_create(n, b.n_links, b.owner, b.neighbour, 0);
    float *const rhs = symmetric_vector(S), *const x = symmetric_vector(S);
    float *const y = symmetric_vector(S), *const now = symmetric_vector(S);
    float *const r = symmetric_vector(S), *const r_now = symmetric_vector(S);
    float *const coarse = symmetric_vector(S);
    int *const parent = alloc_ints(n);

    for (int l = 0; l < b.n_links; l++)
        g[l] = 1.5 + g[l];
    for (int i = 0; i < n; i++) {
        parent[i] = i / 2;
        rhs[i] = (float)(i % 7) - 3.1F;
        coarse[i] = 0.1F * (float)(i % 5);
        sums[i] = i % 100 == 0;
    }
    symmetric_fill(S, g, sums, 0.25);
    for (int i = 0; i < n; i++)
        x[i] = w.first * S->inverse[i] * rhs[i];
    symmetric_relax(S, rhs, x, 1.0F + w.previous, x, 0.0F, w.second, y);
    symmetric_residual(S, rhs, y, r);
    omp_set_num_threads(_i + 1);
    ck_assert(symmetric_descend(S, rhs, w, now, r_now));
    ck_assert_mem_eq(now, y, (size_t)n * sizeof *y);
    ck_assert_mem_eq(r_now, r, (size_t)n * sizeof *r);
    for (int i = 0; i < n; i++)
        y[i] += coarse[parent[i]];
    symmetric_relax(S, rhs, y, 1.0F, y, 0.0F, w.first, x);
    symmetric_relax(S, rhs, x, 1.0F + w.previous, y, -w.previous, w.second, y);
    ck_assert(symmetric_ascend(S, rhs, w, parent, coarse, x, now));
    ck_assert_mem_eq(now, y, (size_t)n * sizeof *y);
    owner_free(S);
    free(g);
    free(sums);
    free(parent);
    links_free(&b);
}
