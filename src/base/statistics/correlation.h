/* correlation.h -- how long a signal remembers.  Chapter "Agitation".
 *
 * Of a series x(t) at n times dt apart, with x'' = x - <x> [EW18 29],
 *
 *   R(tau) = <x''(t + tau) x''(t)> / <x''(t) x''(t)>          [EW18 28]
 *   T = integral of R from 0 to an end tau [EW18 30],
 *
 * as a mean over ends between two times, in which a slow wave cancels
 * [EW18 31].
 */
#ifndef BASE_STATISTICS_CORRELATION_H
#define BASE_STATISTICS_CORRELATION_H

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

#endif
