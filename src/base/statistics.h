/* statistics.h -- what beds and signals are described by, and random numbers.
 * Chapter "Agitation". */
#ifndef BASE_STATISTICS_H
#define BASE_STATISTICS_H

/* --- moments: mean, spread and their errors.
 *
 * Samples that follow each other in time are not independent. The error of a
 * mean is therefore taken from the means of blocks, which are, if a block is
 * longer than what the samples remember.
 */

/* [EW18 23]; 0 of no samples. */
double moments_mean(int n, const double *x);

/* [EW18 24], the root of the mean square deviation: divided by n. */
double moments_deviation(int n, const double *x);

/* Mean cube of the deviation over that of the standard deviation [-]. */
double moments_skewness(int n, const double *x);

/* Standard error of the mean from n / blocks samples each, the first ones that
 * do not fill a block being left out; NAN where there are fewer than two. */
double moments_block_error(int n, const double *x, int blocks);

/* --- correlation: how long a signal remembers.
 *
 * Of a series x(t) at n times dt apart, with x'' = x - <x> [EW18 29],
 *
 *   R(tau) = <x''(t + tau) x''(t)> / <x''(t) x''(t)>          [EW18 28]
 *   T = integral of R from 0 to an end tau [EW18 30],
 *
 * as a mean over ends between two times, in which a slow wave cancels
 * [EW18 31].
 */

/* Adds <x''(t + k dt) x''(t)> for k = 0 .. lags - 1 to c, the mean of the
 * series removed and each lag divided by the number of its pairs; lags <= n. By
 * a fast Fourier transform. */
void correlation_add(int n, const double *x, int lags, double *c);

/* R from such sums: c over c[0]. 0 where nothing varies. */
void correlation_normalise(int lags, const double *c, double *R);

/* The running integral of R by trapezoids, I[0] = 0 [s], dt [s]. */
void correlation_integral(int lags, double dt, const double *R, double *I);

/* T [s]: the mean of I over from <= tau <= to [s]. */
double correlation_time(int lags, double dt, const double *I, double from,
                        double to);

/* --- density: probability densities. */

/* The density p[i] of x in n_bins equal parts of low .. high: its integral is
 * the share of the samples that are in there, which is returned. */
double density_of(int n, const double *x, double low, double high, int n_bins,
                  double *p);

/* --- filter: a finely resolved field as the averaged model sees it. */

/* Mean over the fluid in each coarse box,
 *
 *   sum chi phi V / sum chi V,   chi the fluid fraction of a fine cell,
 *                                                              [EW18 25]
 *
 * of n_fine cells with the volume V and the number of their box; phi has m
 * numbers a cell. mean: m a box, 0 in a box without fluid; chi_mean: the fluid
 * fraction of the box, sum chi V / sum V. */
void filter_boxes(int n_fine, const double *V, const double *chi,
                  const int *box, int m, const double *phi, int n_boxes,
                  double *mean, double *chi_mean);

/* --- sample: a quantity at one Reynolds number and one fluid fraction.
 *
 * EW18 collects drag coefficients [EW18 26] of grains whose Re_p [EW18 27] and
 * eps are within 1 % of given ones, and takes their mean and spread.
 */

struct sample_moments {
    int n;                  /* [-] values that were near */
    double mean, deviation; /* [EW18 23, 24] */
    double deviation_error; /* standard error of the deviation, sigma /
                               sqrt(2 n), if they are independent */
};

/* Of the n values those whose Re and eps are within the share `tolerance` of
 * Re_0 and eps_0. `room` holds n numbers. */
struct sample_moments sample_near(int n, const double *value, const double *Re,
                                  const double *eps, double Re_0, double eps_0,
                                  double tolerance, double *room);

/* --- temperature: how grains fluctuate, and how high they stand. */

/* Mean square of the deviation of a component of the velocity from its mean
 * over all grains at this time [m^2/s^2]. EW18 does not say which mean it
 * takes off; this is the one that a bed as a whole has. */
double temperature_of(int n, const double *v);

/* Height of an even bed [m]: twice the mean height of its grains over the
 * floor. And the height below which the share q of them is; sorts `room`, n
 * numbers. */
double temperature_bed_height(int n, const double *y, double floor);
double temperature_percentile(int n, const double *y, double q, double *room);

/* --- random: random numbers without a state.
 *
 * A number follows from four whole numbers: a seed and three that say what it
 * is for, such as a particle's id and a step. So it does not depend on the
 * order in which numbers are asked for, on the number of threads, or on a
 * restart.
 */

/* 0 <= u < 1, by the mixer of SplitMix64 [Steele14]. */
double random_uniform(unsigned long seed, long i, long j, int which);

/* Of the normal distribution with mean 0 and standard deviation 1; the same
 * mixer, through the inverse of the distribution. Within +-8.2. */
double random_normal(unsigned long seed, long i, long j, int which);

#endif
