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
void facets_free(struct facets *f);

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

#endif
