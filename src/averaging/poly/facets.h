/* facets.h -- the cells of any mesh as bodies with flat facets, and the volume
 * of a ball or a box inside them.
 * Chapter "Further averaging methods".
 *
 *     |ball and cell| = (1/3) sum over facets of
 *         h A_in + R^3 (solid angle of the part outside the ball)      (21.2)
 *
 * h is the distance from the centre to the plane of a facet, positive where the
 * cell is behind it, A_in the area of the facet within the ball. Exact, in
 * closed form, for cells of any number of faces, hollow ones included.
 *
 * A face that is not flat is divided into triangles around the mean of its
 * corners, as where the mesh is measured. The contribution of a facet to the
 * cell on one side is minus that to the cell on the other side, so the parts of
 * a ball in all cells add up to the ball, to rounding.
 *
 * A cell that is its own neighbour across a period is taken with its images.
 */
#ifndef AVERAGING_POLY_FACETS_H
#define AVERAGING_POLY_FACETS_H

#include "mesh/mesh.h"

struct facets {
    const struct mesh *mesh; /* borrowed */
    double *point;           /* [m] of the mesh, then middles of bent faces */
    int *of;                 /* [-] n_polygons + 1; the facets of a polygon */
    double *normal;          /* [-] of each facet, 3 */
    int *start, *corner;     /* [-] the points of each facet */
    double *lo, *hi;         /* [m] ends of each cell, 3 */
    double *V;               /* [m^3] of each cell, between its facets */
    int *ring; /* [-] of each cell, bit i: its own neighbour round period i;
                  NULL without any */
};

/* Requires the shape of the mesh, which a box does not have. The mesh is
 * borrowed. */
struct facets *facets_create(const struct mesh *m);

/* A body around a point. The point is given from the centre of the cell. */
enum facets_body { FACETS_SPHERE, FACETS_CUBE };

/* 1 if the body of half width R [m] is wholly within cell c. */
int facets_contain(const struct facets *f, enum facets_body body, int c,
                   const double from[3], double R);

/* [m^3] of the body in cell c. */
double facets_overlap(const struct facets *f, enum facets_body body, int c,
                      const double from[3], double R);

/* [m^3] of cell c, where the mesh has it, nearer than R [m] to o, or in the box
 * lo .. hi [m]. */
double facets_in_sphere(const struct facets *f, int c, const double o[3],
                        double R);
double facets_in_box(const struct facets *f, int c, const double lo[3],
                     const double hi[3]);

/* --- wall images: the images of cells behind the walls of any mesh.
 *
 * A wall (any boundary face) acts as a mirror: the part of a particle's kernel
 * behind the wall is added to the cell that is mirrored there [EW18 21].
 * Instead of the image of each particle the images of each cell are stored,
 * because cells do not move; the distance is the same.
 *
 * Each point behind the walls is assigned to the nearest wall, and at an edge
 * to the plane that it is farthest beyond. It is the image of the point found
 * by reflection, if necessary repeated, until the result is in the mesh. The
 * images of all cells thus fill the space behind the walls once, in corners of
 * any angle and behind steps. Behind flat walls each image has the size of its
 * cell. Behind concave walls (a tube from inside) inner cells have several
 * images, because the space behind is wider; behind convex walls some cells
 * have none. */

struct wall_image {
    double offset[3]; /* [m] from the centre of the cell to that of its image */
    double rotation[9]; /* [-] maps a vector of the cell to its image; row by
                           row */
    double weight;      /* [-] 1, or less on the bisector of two walls */
};

struct wall_images {
    int *start;                /* [-] n_cells + 1; the images of cell c are */
    struct wall_image *images; /* images[start[c]] ... */
};

/* All images of cells that are at most reach [m] behind a wall. */
struct wall_images *wall_images_create(const struct facets *f, double reach);
void wall_images_free(struct wall_images *m);

/* --- gaussian moments: cells, and their images, as normal densities.
 *
 * The integral of a Gaussian of bandwidth b over a cell is, to fourth order in
 * the width of the cell over b (to third where it is not its own image about
 * its centre),
 *
 *     V N(x - x_c; b^2 / 2 + M)                                        (21.6)
 *
 * with the normal density N of that covariance and with M, the mean of r r^T
 * over the cell: two bodies of the same volume, centre and second moments. */

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

/* V N where r [m] is from the centre of the cell; 0 from exp(-9) on. */
double gaussian_moments_value(const struct gaussian_moment *n,
                              const double r[3]);

#endif
