/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/level_matrix.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/parallel_ranges.h"
#include "linear/matrix.h"
#include "linear/reduce.h"

/* The matrix by rows, in double. */
struct rows {
    struct csr *A;
    double unit;    /* [1/coefficient] */
    float *inverse; /* one over the diagonal times unit; 0 for a row of zeros */
};

static void *level_matrix_create(int n, int n_links, const int *owner,
                                 const int *neighbour, int exact)
{
    struct rows *const m = alloc_zeroed(1, sizeof *m);

    (void)exact;
    m->A = csr_create(n, n_links, owner, neighbour);
    m->inverse = alloc_zeroed((size_t)n, sizeof *m->inverse);
    return m;
}

static void level_matrix_release(void *data)
{
    struct rows *const m = data;

    if (m == NULL) return;
    csr_free(m->A);
    free(m->inverse);
    free(m);
}

static float *level_matrix_vector(const void *data)
{
    const struct rows *const m = data;

    return alloc_zeroed((size_t)m->A->n, sizeof(float));
}

static void level_matrix_vector_free(const void *data, float *x)
{
    (void)data;
    free(x);
}

static void level_matrix_fill(void *data, const double *g, const double *sums,
                              double unit)
{
    struct rows *const m = data;
    struct csr *const A = m->A;

    m->unit = unit;
    csr_set_diffusion(A, g, sums);
    for (int i = 0; i < A->n; i++)
        m->inverse[i] =
            A->diag[i] > 0.0 ? (float)(1.0 / (unit * A->diag[i])) : 0.0F;
}

static const float *level_matrix_inverse(const void *data)
{
    const struct rows *const m = data;

    return m->inverse;
}

/* Row i of b - unit A x, computed in double. */
static double residual_of_row(const struct rows *m, int i, const float *b,
                              const float *x)
{
    const struct csr *const A = m->A;
    double sum = A->diag[i] * (double)x[i];

    for (int e = A->start[i]; e < A->start[i + 1]; e++)
        sum += A->a[e] * (double)x[A->col[e]];
    return (double)b[i] - m->unit * sum;
}

static void level_matrix_residual_rows(int first, int last,
                                       const struct rows *m, const float *b,
                                       const float *x, float *r)
{
    for (int i = first; i < last; i++)
        r[i] = (float)residual_of_row(m, i, b, x);
}

static void level_matrix_residual(const void *data, const float *b,
                                  const float *x, float *r)
{
    const struct rows *const m = data;

    PARALLEL_RANGES(m->A->n, 4, level_matrix_residual_rows, m, b, x, r);
}

static void level_matrix_relax_rows(int first, int last, const struct rows *m,
                                    const float *b, const float *x, float alpha,
                                    const float *w, float beta, float gamma,
                                    float *y)
{
    for (int i = first; i < last; i++)
        y[i] = alpha * x[i] + beta * w[i] +
               gamma * m->inverse[i] * (float)residual_of_row(m, i, b, x);
}

static void level_matrix_relax(const void *data, const float *b, const float *x,
                               float alpha, const float *w, float beta,
                               float gamma, float *y)
{
    const struct rows *const m = data;

    PARALLEL_RANGES(m->A->n, 4, level_matrix_relax_rows, m, b, x, alpha, w,
                    beta, gamma, y);
}

static double level_matrix_multiply(const void *data, const double *x,
                                    double *y)
{
    const struct rows *const m = data;

    csr_multiply(m->A, x, y);
    return reduce_dot(m->A->n, x, y);
}

const struct level_matrix_kind level_matrix_rows = {"rows",
                                                    level_matrix_create,
                                                    level_matrix_release,
                                                    level_matrix_vector,
                                                    level_matrix_vector_free,
                                                    level_matrix_fill,
                                                    level_matrix_inverse,
                                                    level_matrix_residual,
                                                    level_matrix_relax,
                                                    level_matrix_multiply,
                                                    NULL,
                                                    NULL};

/* --- dense ---------------------------------------------------------------- */

/* Of the largest diagonal entry: a pivot below is what rounding left of a sum
 * over millions of cells. */
static const double rounding = 1e-12;

struct dense {
    int n;
    double *a;       /* columns; after factoring, L below the diagonal */
    double *inverse; /* one over the pivots, 0 for a pivot that vanished */
};

struct dense *dense_create(int n)
{
    struct dense *const D = alloc_zeroed(1, sizeof *D);

    D->n = n;
    D->a = alloc_doubles(n * n);
    D->inverse = alloc_doubles(n);
    return D;
}

void dense_free(struct dense *D)
{
    if (D == NULL) return;
    free(D->a);
    free(D->inverse);
    free(D);
}

double *dense_matrix(struct dense *D)
{
    return D->a;
}

void dense_factor(struct dense *D)
{
    const int n = D->n;
    double most = 0.0;

    for (int j = 0; j < n; j++)
        most = fmax(most, D->a[j * n + j]);
    for (int j = 0; j < n; j++) {
        double *const column = D->a + j * n;
        const int regular = column[j] > rounding * most;

        D->inverse[j] = regular ? 1.0 / column[j] : 0.0;
        for (int k = j + 1; k < n; k++) {
            const double factor = column[k] * D->inverse[j];

            for (int i = k; i < n; i++)
                D->a[k * n + i] -= factor * column[i];
        }
        for (int i = j + 1; i < n; i++)
            column[i] *= D->inverse[j];
    }
}

void dense_solve(const struct dense *D, const double *b, double *x)
{
    const int n = D->n;

    for (int i = 0; i < n; i++)
        x[i] = b[i];
    for (int j = 0; j < n; j++) {
        const double *const column = D->a + j * n;

        for (int i = j + 1; i < n; i++)
            x[i] -= column[i] * x[j];
    }
    for (int j = n - 1; j >= 0; j--) {
        const double *const column = D->a + j * n;
        double sum = x[j] * D->inverse[j];

        for (int i = j + 1; i < n; i++)
            sum -= column[i] * x[i];
        x[j] = sum;
    }
}
