/* sample.h -- a quantity at one Reynolds number and one fluid fraction.
 * Chapter "Agitation".
 *
 * EW18 collects drag coefficients [EW18 26] of grains whose Re_p [EW18 27] and
 * eps are within 1 % of given ones, and takes their mean and spread.
 */
#ifndef BASE_STATISTICS_SAMPLE_H
#define BASE_STATISTICS_SAMPLE_H

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

#endif
