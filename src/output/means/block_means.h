/* block_means.h -- the statistical error of means over time.
 * Chapter "Output".
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
#ifndef OUTPUT_MEANS_BLOCK_MEANS_H
#define OUTPUT_MEANS_BLOCK_MEANS_H

#include "base/state.h"

struct block_means;

/* For n numbers at once. */
struct block_means *block_means_create(int n);
void block_means_free(struct block_means *b);

/* Adds a sample x[0 .. n-1] of weights w [dt, times the amount of the phase];
 * where a weight is 0 its x may be nan. */
void block_means_add(struct block_means *b, const double *x, const double *w);

/* The error of the mean of number i, in its unit; nan while there are fewer
 * than 8 blocks. A block that is not full yet is left out. */
double block_means_error(const struct block_means *b, int i);

/* The blocks so far (state.h). */
void block_means_state(struct block_means *b, struct state *s);

#endif
