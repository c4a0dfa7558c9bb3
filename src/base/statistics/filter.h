/* filter.h -- a finely resolved field as the averaged model sees it.
 * Chapter "Agitation".
 */
#ifndef BASE_STATISTICS_FILTER_H
#define BASE_STATISTICS_FILTER_H

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

#endif
