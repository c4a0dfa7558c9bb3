/* vector.h -- vector operations in three dimensions. */
#ifndef BASE_VECTOR_H
#define BASE_VECTOR_H

#include <math.h>

/* The scalar product of a and b. */
static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The length of a. */
static inline double vector_length(const double a[3])
{
    return sqrt(vector_dot(a, a));
}

/* e = a over its length; 0 of no length. */
static inline void vector_unit(const double a[3], double e[3])
{
    const double length = vector_length(a);

    for (int k = 0; k < 3; k++)
        e[k] = length > 0.0 ? a[k] / length : a[k];
}

/* c = a x b; c is another array than a and b. */
static inline void vector_cross(const double a[3], const double b[3],
                                double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* c = a + s b. */
static inline void vector_along(const double a[3], double s, const double b[3],
                                double c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = a[k] + s * b[k];
}

/* c = a - b. */
static inline void vector_between(const double a[3], const double b[3],
                                  double c[3])
{
    vector_along(a, -1.0, b, c);
}

/* Two unit vectors normal to the unit vector n and to each other. */
static inline void vectors_across(const double n[3], double e[3], double f[3])
{
    const double other[3] = {fabs(n[0]) < 0.5, fabs(n[0]) >= 0.5, 0.0};

    vector_cross(n, other, e);
    const double length = vector_length(e);
    for (int k = 0; k < 3; k++)
        e[k] /= length;
    vector_cross(n, e, f);
}

/* The axis that it has most of; y, where no other has more. */
static inline int vector_axis(const double a[3])
{
    int axis = 1;

    for (int k = 0; k < 3; k++)
        if (fabs(a[k]) > fabs(a[axis])) axis = k;
    return axis;
}

/* The index of A_jk in the order xx, xy, xz, yy, yz, zz. */
static inline int vector_place(int j, int k)
{
    static const int at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return at[j][k];
}

/* Solves A x = b for a symmetric positive semidefinite A, stored as xx, xy, xz,
 * yy, yz, zz. It may have rows of zeros, where x is 0; entries far below the
 * largest count as zero. Elimination without pivoting: A is a sum of squares,
 * r r^T. A pivot far below the largest entry is a direction that no r has. */
static inline void vector_solve(const double A[6], const double b[3],
                                double x[3])
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

#endif
