/* statistics.h -- means with their errors, orders, extrapolation.
 *
 * The samples of a time series follow each other too closely to be independent.
 * Means of blocks of them are, once the blocks are long enough: the standard
 * error that follows from the scatter of the blocks grows with their length up
 * to the true one [Flyvbjerg89].
 */
#ifndef STUDY_STATISTICS_H
#define STUDY_STATISTICS_H

double statistics_mean(int n, const double *x);

/* Standard error of the mean of n independent samples; 0 of one. */
double statistics_error(int n, const double *x);

/* Standard error of the mean of a time series: the largest that blocks of 1, 2,
 * 4, ... samples give, with at least 8 blocks; 0 for fewer than 8 samples. */
double statistics_block_error(int n, const double *x);

/* y at x = at, linear between the points; nan beyond them. x rises. */
double statistics_between(int n, const double *x, const double *y, double at);

/* The order p at which an error falls from one size h to a smaller one. */
double statistics_order(double h_coarse, double e_coarse, double h_fine,
                        double e_fine);

/* Richardson's extrapolation: of a value q(h) = q_0 + C h^p at three sizes that
 * get smaller, the order p from the ratio of the two changes, |q_2 - q_1| /
 * |q_3 - q_2|. nan if no p from 0.1 to 12 fits. */
double statistics_richardson(const double h[3], double ratio);

#endif
