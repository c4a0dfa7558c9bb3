/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "linear/multigrid/level_matrix.h"

#include <math.h>

#include "base/alloc.h"

/* Of the largest diagonal entry: a pivot below is what rounding left of a sum
 * over millions of cells. */
static const double rounding = 1e-12;

struct dense *dense_create(int n)
{
    struct dense *const D = owner_create(sizeof *D);

    D->n = n;
    D->a = owner_doubles(D, n * n);
    D->inverse = owner_doubles(D, n);
    return D;
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
