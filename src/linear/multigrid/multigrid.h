/* multigrid.h -- a preconditioner: one cycle of multigrid by aggregation.
 * Chapter "Linear solvers".
 *
 * Cells are joined into aggregates, and aggregates into larger ones, until a
 * few are left. The aggregates depend on the geometry alone and are formed
 * once; when the matrix changes, only the sums of its coefficients are formed
 * again, level by level. Each coarse coefficient is divided by the ratio of the
 * length of its link to those of the links in the sum, because piecewise
 * constant corrections are too stiff by that factor. One application is one
 * symmetric cycle, smoothed by Chebyshev polynomials of degree two: the
 * smoother consists of matrix products only, so it is parallel, vectorised, and
 * gives the same bits for any number of threads.
 */
#ifndef LINEAR_MULTIGRID_MULTIGRID_H
#define LINEAR_MULTIGRID_MULTIGRID_H

#include "linear/solvers.h"

struct multigrid;

/* The preconditioner whose matrix is a struct multigrid. */
extern const struct preconditioned_kind multigrid_preconditioned;

/* The functions of that kind, whose `matrix` is a struct multigrid. Aggregates
 * for the unknowns and links of a csr (same order). V and the
 * arrays of links are borrowed during the call only. */
void *multigrid_create(int n, int n_links, const int *owner,
                       const int *neighbour,
                       const double *strength, /* [m] |S|/|d| */
                       const double *link,     /* [m] 3 a link */
                       const double *V);       /* [m^3] */

/* Sets the coefficients: g of the links, with the entries -g off the diagonal,
 * and the sums of the rows; both >= 0. */
void multigrid_set_coefficients(void *mg, const double *g, const double *sums);

/* z = M r, one cycle from zero, in single precision inside: a symmetric
 * positive definite M. Returns r.z. */
double multigrid_apply(struct multigrid *mg, const double *r, double *z);

/* For reports: the number of levels, and the unknowns of one of them. */
int multigrid_levels(const struct multigrid *mg);
int multigrid_unknowns(const struct multigrid *mg, int level);

#endif
