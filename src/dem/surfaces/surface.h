/* surface.h -- a wall that is not one of the box.
 * Chapter "Walls".
 *
 * The solid of a plane lies behind it, that of a cylinder around or in it, that
 * of a sphere in it: a particle whose centre is in the solid is pushed out.
 * Triangles have two sides and no thickness; the force points to the side of
 * the centre.
 */
#ifndef DEM_SURFACES_SURFACE_H
#define DEM_SURFACES_SURFACE_H

#include "dem/surfaces/surface_shape.h"
#include "dem/surfaces/motion.h"
#include "dem/surfaces/triangles.h"

struct surface {
    const char *name; /* borrowed */
    const struct surface_shape *shape;
    int material;              /* [-] number of it */
    double point[3];           /* [m] on the plane, on the axis; or centre */
    double normal[3];          /* [-] out of the solid; or the axis */
    double radius;             /* [m] of cylinder, sphere */
    int inside;                /* [-] 1: particles are within it */
    double own[MODEL_NUMBERS]; /* of the keys that the shape alone reads */
    const struct triangles *triangles; /* borrowed; NULL of other shapes */
    struct motion motion;              /* the places above are of time 0 */
};

/* As a case writes it. */
struct surface_setup {
    struct surface of; /* completed by the case; normal of any length before */
    double axis[3];    /* [-] of any length */
    const char *particles; /* "inside" or "outside" */
    const char *material, *file;
    struct triangles *triangles; /* of the file */
    double scale;                /* [m] the unit of the file */
    int has_centre;              /* [-] 1: of.motion.centre is given */
};

/* The only face of a shape is number 0, that of triangles the number of one. y
 * and the answer are in the frame of the surface, as at time 0. */
struct surface_hit surface_nearest(const struct surface *s, int face,
                                   const double y[3]);

/* The same in the frame of the box: x is moved to the surface and the answer
 * back. */
struct surface_hit surface_nearest_moved(const struct surface *s, int face,
                                         const struct pose *p,
                                         const double x[3]);

/* 1 if x is in the solid of a shape, deeper than R. Triangles have no solid: 0.
 */
int surface_contains(const struct surface *s, const struct pose *p,
                     const double x[3], double R);

/* Largest distance [m] of its points within the box from the centre of its
 * motion, at time 0. */
double surface_reach(const struct surface *s, const double lo[3],
                     const double hi[3]);

/* Non-zero after one message if its numbers make no surface. */
int surface_wrong(const struct surface *s);

#endif
