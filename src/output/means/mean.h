/* mean.h -- running means over time of many numbers at once.
 *
 * With a weight w_k for each sample x_k (its interval of time, and for phase
 * averages the amount of the phase present):
 *
 *     mean = sum w x / sum w,   spread = sqrt(sum w (x - mean)^2 / sum w)
 *
 * updated sample by sample [Welford62, West79], which keeps the spread
 * exact where the difference of the two sums would cancel.
 */
#ifndef OUTPUT_MEANS_MEAN_H
#define OUTPUT_MEANS_MEAN_H

#include "base/state.h"

struct mean {
    int n;
    double *weight; /* [unit of w] sum of w, one a number */
    double *value;  /* [unit of x] mean so far; nan where weight is 0 */
    double *square; /* [unit of w x^2] sum of w (x - mean)^2 */
};

struct mean *mean_create(int n);
void mean_free(struct mean *m);

/* Adds x[0 .. n-1] for an interval of dt [s], each further weighted by w[i] >=
 * 0; NULL for equal weights. A weight of 0 leaves its mean as it is. */
void mean_add(struct mean *m, double dt, const double *x, const double *w);

/* Spread over time of number i; nan where weight is 0. */
double mean_spread(const struct mean *m, int i);

/* All sums (state.h). */
void mean_state(struct mean *m, struct state *s);

#endif
