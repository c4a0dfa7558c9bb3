/* temperature.h -- how grains fluctuate, and how high they stand.
 * Chapter "Agitation".
 */
#ifndef BASE_STATISTICS_TEMPERATURE_H
#define BASE_STATISTICS_TEMPERATURE_H

/* Mean square of the deviation of a component of the velocity from its mean
 * over all grains at this time [m^2/s^2]. EW18 does not say which mean it
 * takes off; this is the one that a bed as a whole has. */
double temperature_of(int n, const double *v);

/* Height of an even bed [m]: twice the mean height of its grains over the
 * floor. And the height below which the share q of them is; sorts `room`, n
 * numbers. */
double temperature_bed_height(int n, const double *y, double floor);
double temperature_percentile(int n, const double *y, double q, double *room);

#endif
