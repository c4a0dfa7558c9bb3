/* gaussian_moments.h -- cells, and their images, as normal densities.
 *
 * Chapter "Further averaging methods".
 *
 * The integral of a Gaussian of bandwidth b over a cell is, to fourth order in
 * the width of the cell over b (to third where it is not its own image about
 * its centre),
 *
 *     V N(x - x_c; b^2 / 2 + M)                                        (21.6)
 *
 * with the normal density N of that covariance and with M, the mean of r r^T
 * over the cell: two bodies of the same volume, centre and second moments.
 */
#ifndef AVERAGING_POLY_GAUSSIAN_MOMENTS_H
#define AVERAGING_POLY_GAUSSIAN_MOMENTS_H

#include "averaging/poly/wall_images.h"

struct gaussian_moment {
    double A[6]; /* [1/m^2] half the inverse covariance: xx xy xz yy yz zz */
    double offset[3]; /* [m] from the centre of the cell */
    double height;    /* [m^3] of V N, times (2 pi b^2 / 2)^(3/2) */
};

struct gaussian_moments {
    int *start; /* [-] n_cells + 1; a cell and its images are */
    struct gaussian_moment *moment; /* moment[start[c]] ..., the cell first */
    double *spread; /* [m] of each cell, 9: the columns of L, L L^T = M */
};

struct gaussian_moments *gaussian_moments_create(const struct facets *f,
                                                 const struct wall_images *m,
                                                 double b);
void gaussian_moments_free(struct gaussian_moments *s);

/* V N where r [m] is from the centre of the cell; 0 from exp(-9) on. */
double gaussian_moments_value(const struct gaussian_moment *n,
                              const double r[3]);

#endif
