/* density.h -- probability densities.  Chapter "Agitation". */
#ifndef BASE_STATISTICS_DENSITY_H
#define BASE_STATISTICS_DENSITY_H

/* The density p[i] of x in n_bins equal parts of low .. high: its integral is
 * the share of the samples that are in there, which is returned. */
double density_of(int n, const double *x, double low, double high, int n_bins,
                  double *p);

#endif
