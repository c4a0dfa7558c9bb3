/* vector.h -- vector operations in three dimensions. */
#ifndef BASE_VECTOR_H
#define BASE_VECTOR_H

#include <math.h>

static inline double vector_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline double vector_length(const double a[3])
{
    return sqrt(vector_dot(a, a));
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

/* The axis that it has most of; y, where no other has more. */
static inline int vector_axis(const double a[3])
{
    int axis = 1;

    for (int k = 0; k < 3; k++)
        if (fabs(a[k]) > fabs(a[axis])) axis = k;
    return axis;
}

/* Solves A x = b for a symmetric positive semidefinite A, stored as xx, xy, xz,
 * yy, yz, zz. It may have rows of zeros, where x is 0; entries far below the
 * largest count as zero. */
void vector_solve(const double A[6], const double b[3], double x[3]);

#endif
