/* SPDX-License-Identifier: GPL-3.0-or-later */
/* level_matrix_bands.c -- the matrices of multigrid stored by diagonals. */
#include "linear/multigrid/level_matrix.h"

#include "linear/fast/symmetric.h"

static void *create(int n, int n_links, const int *owner, const int *neighbour,
                    int exact)
{
    return symmetric_create(n, n_links, owner, neighbour, exact);
}

static void release(void *data)
{
    symmetric_free(data);
}

static float *vector(const void *data)
{
    return symmetric_vector(data);
}

static void vector_free(const void *data, float *x)
{
    symmetric_vector_free(data, x);
}

static void fill(void *data, const double *g, const double *sums, double unit)
{
    symmetric_fill(data, g, sums, unit);
}

static const float *inverse(const void *data)
{
    const struct symmetric *const S = data;

    return S->inverse;
}

static void residual(const void *data, const float *b, const float *x, float *r)
{
    symmetric_residual(data, b, x, r);
}

static void relax(const void *data, const float *b, const float *x, float alpha,
                  const float *w, float beta, float gamma, float *y)
{
    symmetric_relax(data, b, x, alpha, w, beta, gamma, y);
}

static double multiply(const void *data, const double *x, double *y)
{
    return symmetric_multiply(data, x, y);
}

const struct level_matrix_kind level_matrix_bands = {
    "bands", create,  release,  vector, vector_free,
    fill,    inverse, residual, relax,  multiply};
