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

/* --- the statistical error of means over time. Chapter "Output". -----------
 *
 * Samples that follow each other are not independent. The series is cut into
 * blocks, and the spread of their means b_i gives the error of the whole:
 *
 *     error^2 = 1 / (m (m - 1)) sum_i (b_i - mean)^2                   (12.6)
 *
 * for blocks of one weight; a block with another one counts by it. It grows
 * with the length of the blocks until they are independent [Flyvbjerg89], so
 * the largest is taken of all lengths that leave at least 8 blocks. The end of
 * the series need not be known: when there are 32 blocks, neighbours are
 * joined, and the next ones are twice as long.
 */
struct mean_blocks;

/* For n numbers at once. */
struct mean_blocks *mean_blocks_create(int n);
void mean_blocks_free(struct mean_blocks *b);

/* Adds a sample x[0 .. n-1] of weights w [dt, times the amount of the phase];
 * where a weight is 0 its x may be nan. */
void mean_blocks_add(struct mean_blocks *b, const double *x, const double *w);

/* The error of the mean of number i, in its unit; nan while there are fewer
 * than 8 blocks. A block that is not full yet is left out. */
double mean_blocks_error(const struct mean_blocks *b, int i);

/* The blocks so far (state.h). */
void mean_blocks_state(struct mean_blocks *b, struct state *s);

#endif
