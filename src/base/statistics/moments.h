/* moments.h -- mean, spread and their errors.  Chapter "Agitation".
 *
 * Samples that follow each other in time are not independent. The error of a
 * mean is therefore taken from the means of blocks, which are, if a block is
 * longer than what the samples remember.
 */
#ifndef BASE_STATISTICS_MOMENTS_H
#define BASE_STATISTICS_MOMENTS_H

/* [EW18 23]; 0 of no samples. */
double moments_mean(int n, const double *x);

/* [EW18 24], the root of the mean square deviation: divided by n. */
double moments_deviation(int n, const double *x);

/* Mean cube of the deviation over that of the standard deviation [-]. */
double moments_skewness(int n, const double *x);

/* Standard error of the mean from n / blocks samples each, the first ones that
 * do not fill a block being left out; NAN where there are fewer than two. */
double moments_block_error(int n, const double *x, int blocks);

#endif
