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

/* dot[k] = sum_i x[m * i + k] y[m * i + k] for m fields side by side. */
void reduce_range_many(int first, int last, int m, const double *x,
                       const double *y, double *dot);

#endif
