/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/level_matrix.h"

#include "facts.h"
#include "linear_case.h"

/* A box, one that is periodic and one cell thick, and one without an order. */
static struct links links_of(int which)
{
    struct links b = which == 1 ? links_box(40, 20, 1, (double[3]){1, 2, 3},
                                            (int[3]){1, 1, 1})
                                : links_cube(12, 10, 8);

    if (which == 2) links_shuffle(&b, 3);
    return b;
}

/* Products of one kind with given numbers. */
struct products {
    float *r, *y;
    double *Ax, xAx;
};

static struct products products_of(const struct level_matrix_kind *kind,
                                   const struct links *b)
{
    struct products p = {alloc_zeroed((size_t)b->n, sizeof(float)), NULL,
                         alloc_doubles(b->n), 0.0};
    double *const g = noise_vector(b->n_links, 1);
    double *const sums = noise_vector(b->n, 2), *const x =
                                                    noise_vector(b->n, 3);
    void *const A = kind->create(b->n, b->n_links, b->owner, b->neighbour, 1);
    float *const z = kind->vector(A);
    float *const right = alloc_zeroed((size_t)b->n, sizeof *right);

    p.y = alloc_zeroed((size_t)b->n, sizeof(float));
    for (int l = 0; l < b->n_links; l++)
        g[l] = 2.0 + g[l];
    for (int i = 0; i < b->n; i++) {
        sums[i] = 1.0 + sums[i];
        z[i] = (float)x[i];
        right[i] = (float)(x[i] * x[i]);
        p.y[i] = right[i];
    }
    kind->fill(A, g, sums, 0.25);
    kind->residual(A, right, z, p.r);
    kind->relax(A, right, z, 0.5F, p.y, 0.25F, 0.75F, p.y);
    p.xAx = kind->multiply(A, x, p.Ax);
    kind->vector_free(A, z);
    kind->free(A);
    free(g);
    free(sums);
    free(x);
    free(right);
    return p;
}

static void release(struct products *p)
{
    free(p->r);
    free(p->y);
    free(p->Ax);
}

/* Seven terms of order one in single precision; of order ten in double. */
FACT_FOR_EACH(a_matrix_that_is_stored_for_speed_is_that_by_rows, 3)
{
    struct links b = links_of(_i);
    struct products rows = products_of(&level_matrix_rows, &b);

    struct products fast = products_of(&level_matrix_bands, &b);

    for (int i = 0; i < b.n; i++) {
        ck_assert_double_eq_tol(fast.r[i], rows.r[i], 5e-6);
        ck_assert_double_eq_tol(fast.y[i], rows.y[i], 5e-6);
        ck_assert_double_eq_tol(fast.Ax[i], rows.Ax[i], 5e-14);
    }
    ck_assert_double_eq_tol(fast.xAx, rows.xAx, 1e-10);
    release(&fast);
    release(&rows);
    links_free(&b);
}

/* A constant loses only what the row sums say: 1 where they are 1. */
FACT_FOR_EACH(the_rows_have_the_sums_that_were_given, 3)
{
    struct links b = links_of(_i);
    double *const one = alloc_doubles(b.n), *const y = alloc_doubles(b.n);
    double *const g = noise_vector(b.n_links, 1);
    const struct level_matrix_kind *const kind = &level_matrix_rows;
    void *const A = kind->create(b.n, b.n_links, b.owner, b.neighbour, 1);

    for (int l = 0; l < b.n_links; l++)
        g[l] = 2.0 + g[l];
    for (int i = 0; i < b.n; i++)
        one[i] = 1.0;
    kind->fill(A, g, one, 1.0);
    kind->multiply(A, one, y);
    for (int i = 0; i < b.n; i++)
        ck_assert_double_eq_tol(y[i], 1.0, 2e-14);
    kind->free(A);
    free(one);
    free(y);
    free(g);
    links_free(&b);
}
