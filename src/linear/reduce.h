/* reduce.h -- scalar products, with the same bits for any number of threads.
 *
 * A range is summed in a fixed number of lanes, so that the compiler vectorises
 * it; the sums of the ranges are added in a fixed order (parallel_ranges.h).
 */
#ifndef LINEAR_REDUCE_H
#define LINEAR_REDUCE_H

enum { REDUCE_FIELDS = 16 }; /* at most, side by side */

/* sum_i x_i y_i, over all unknowns and over first <= i < last. */
double reduce_dot(int n, const double *x, const double *y);
double reduce_range(int first, int last, const double *x, const double *y);

/* sum_i x_i (factor y_i), with y in single precision. */
double reduce_range_scaled(int first, int last, const double *x, const float *y,
                           double factor);

/* dot[k] = sum_i x[m * i + k] y[m * i + k] for m fields side by side. */
void reduce_range_many(int first, int last, int m, const double *x,
                       const double *y, double *dot);

/* Vectorised products of one number a cell with three numbers a cell.
 *
 * Where three interleaved components are multiplied by the same number, a
 * compiler generates shuffles of both vectors. It is faster to write that
 * number three times, for a few cells at once, and to use plain loops
 * (measured: 1.6 times for a product, more where several numbers of a cell are
 * used). */

enum {
    VEC3_BLOCK = 128 /* cells at once: their numbers stay in the cache */
};

/* a3[3 i + k] = a[i] for n cells. */
static inline void vec3_spread(int n, const double *restrict a,
                               double *restrict a3)
{
    for (int i = 0; i < n; i++) {
        a3[3 * i] = a[i];
        a3[3 * i + 1] = a[i];
        a3[3 * i + 2] = a[i];
    }
}

/* y[3 i + k] += factor a[i] x[3 i + k] for n cells; y is apart from the rest.
 * Of eight cells the numbers stay in registers. */
static inline void vec3_add(int n, double factor, const double *restrict a,
                            const double *restrict x, double *restrict y)
{
    int i = 0;

    for (; i + 8 <= n; i += 8) {
        double a3[24];

        vec3_spread(8, a + i, a3);
        for (int j = 0; j < 24; j++)
            y[3L * i + j] += factor * a3[j] * x[3L * i + j];
    }
    for (; i < n; i++)
        for (int k = 0; k < 3; k++)
            y[3L * i + k] += factor * a[i] * x[3L * i + k];
}

/* sum[k] += a[i] x[3 i + k] over n cells. */
static inline void vec3_sum(int n, const double *restrict a,
                            const double *restrict x, double sum[3])
{
    double a3[3 * VEC3_BLOCK], part[3];

    for (int i = 0; i < n; i += VEC3_BLOCK) {
        const int m = n - i < VEC3_BLOCK ? n - i : VEC3_BLOCK;

        vec3_spread(m, a + i, a3);
        reduce_range_many(0, m, 3, a3, x + 3L * i, part);
        for (int k = 0; k < 3; k++)
            sum[k] += part[k];
    }
}

#endif
