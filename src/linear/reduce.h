/* reduce.h -- sums over all unknowns, with the same bits for any number of
 * threads.
 *
 * The range is cut into a fixed number of strips, whoever computes them; a
 * strip is summed in a fixed number of lanes (so that it vectorises), and the
 * strips are added in order.
 */
#ifndef REDUCE_H
#define REDUCE_H

enum {
    REDUCE_STRIPS = 64,
    REDUCE_FIELDS = 16,      /* at most, side by side */
    REDUCE_THREADED = 20000, /* [-] a loop over fewer numbers than this is
                                faster in one thread than woken up in two */
};

/* The first of n unknowns in strip s; strip REDUCE_STRIPS begins at n. */
static inline int reduce_strip(int n, int s)
{
    const int rows = ((n + REDUCE_STRIPS - 1) / REDUCE_STRIPS + 15) / 16 * 16;
    const long first = (long)s * rows;

    return first < n ? (int)first : n;
}

/* sum_i x_i y_i, over all unknowns and over first <= i < last. */
double reduce_dot(int n, const double *x, const double *y);
double reduce_range(int first, int last, const double *x, const double *y);

/* The sum of the strips, in order. */
double reduce_strips(const double strip[REDUCE_STRIPS]);

/* dot[k] = sum_i x[m * i + k] y[m * i + k] for m fields side by side. */
void reduce_dot_many(int n, int m, const double *x, const double *y,
                     double *dot);

#endif
