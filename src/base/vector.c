/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/vector.h"

/* The index of A_jk in the order xx, xy, xz, yy, yz, zz. */
static int vector_place(int j, int k)
{
    static const int at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return at[j][k];
}

/* Elimination without pivoting: A is a sum of squares, r r^T. A pivot far below
 * the largest entry is a direction that no r has. */
void vector_solve(const double A[6], const double b[3], double x[3])
{
    const double tiny = 1e-10 * fmax(A[0], fmax(A[3], A[5]));
    double a[3][4];

    for (int j = 0; j < 3; j++) {
        for (int k = 0; k < 3; k++)
            a[j][k] = A[vector_place(j, k)];
        a[j][3] = b[j];
    }
    for (int j = 0; j < 3; j++)
        for (int i = j + 1; i < 3 && a[j][j] > tiny; i++) {
            const double factor = a[i][j] / a[j][j];
            for (int k = j; k < 4; k++)
                a[i][k] -= factor * a[j][k];
        }
    for (int j = 2; j >= 0; j--) {
        x[j] = a[j][3];
        for (int k = j + 1; k < 3; k++)
            x[j] -= a[j][k] * x[k];
        x[j] = a[j][j] > tiny ? x[j] / a[j][j] : 0.0;
    }
}
