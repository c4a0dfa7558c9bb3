/* SPDX-License-Identifier: GPL-3.0-or-later */
/* level_matrix_bands.c -- the matrices of multigrid stored by diagonals. */
#include "linear/multigrid/level_matrix.h"

#include "linear/fast/symmetric.h"

static void *level_matrix_bands_create(int n, int n_links, const int *owner,
                                       const int *neighbour, int exact)
{
    return symmetric_create(n, n_links, owner, neighbour, exact);
}

static void level_matrix_bands_release(void *data)
{
    symmetric_free(data);
}

static float *level_matrix_bands_vector(const void *data)
{
    return symmetric_vector(data);
}

static void level_matrix_bands_free_vector(const void *data, float *x)
{
    symmetric_vector_free(data, x);
}

static void level_matrix_bands_fill(void *data, const double *g,
                                    const double *sums, double unit)
{
    symmetric_fill(data, g, sums, unit);
}

static const float *level_matrix_bands_inverse(const void *data)
{
    const struct symmetric *const S = data;

    return S->inverse;
}

static void level_matrix_bands_residual(const void *data, const float *b,
                                        const float *x, float *r)
{
    symmetric_residual(data, b, x, r);
}

static void level_matrix_bands_relax(const void *data, const float *b,
                                     const float *x, float alpha,
                                     const float *w, float beta, float gamma,
                                     float *y)
{
    symmetric_relax(data, b, x, alpha, w, beta, gamma, y);
}

static double level_matrix_bands_multiply(const void *data, const double *x,
                                          double *y)
{
    return symmetric_multiply(data, x, y);
}

const struct level_matrix_kind level_matrix_bands = {
    "bands",
    level_matrix_bands_create,
    level_matrix_bands_release,
    level_matrix_bands_vector,
    level_matrix_bands_free_vector,
    level_matrix_bands_fill,
    level_matrix_bands_inverse,
    level_matrix_bands_residual,
    level_matrix_bands_relax,
    level_matrix_bands_multiply};
