/* surface_shape.h -- the descriptor of a shape that a surface can have.
 * Chapter "Walls".
 *
 * A shape is one file with one descriptor. Its solid is where the distance r is
 * negative: a particle whose centre is there is pushed out, along n.
 */
#ifndef DEM_SURFACES_SURFACE_SHAPE_H
#define DEM_SURFACES_SURFACE_SHAPE_H

#include "base/model.h"

struct surface;

/* The position of a point relative to one face of a surface. */
struct surface_hit {
    double r;    /* [m] distance; negative in the solid of a shape */
    double n[3]; /* [-] from the face to the point */
    double q[3]; /* [m] the nearest point of the face */
};

struct surface_shape {
    MODEL_MEMBERS;              /* base/model.h */
    const struct key *own_keys; /* of these the one whose numbers are in
                                   surface.own (base/model.h); NULL: none */
    /* The nearest point to y [m], in the frame of the surface, as at time 0;
     * NULL: the shape is made of triangles. */
    struct surface_hit (*nearest)(const struct surface *s, const double y[3]);
    /* Largest distance [m] of its points from the centre of its motion; NULL:
     * that of the corners of the box. */
    double (*reach)(const struct surface *s);
    /* What is wrong with its numbers, in words; NULL: nothing is. */
    const char *(*wrong)(const struct surface *s);
    /* Its point x [m] for two numbers a, b from 0 to 1, for display; lo and hi
     * are the ends of the box. NULL: plane, cylinder and triangles are drawn in
     * ways of their own. */
    void (*point)(const struct surface *s, double a, double b,
                  const double lo[3], const double hi[3], double x[3]);
};

/* What a case can choose, ended by NULL. */
extern const struct surface_shape *const surface_shapes[];

extern const struct surface_shape surface_plane, surface_cylinder, surface_stl;
/* The outside of a body in a fluid, which no case names. */
extern const struct surface_shape surface_sphere;

/* Keys of several shapes: the members point, normal (the axis), radius and
 * inside of struct surface. */
extern const struct key surface_point_keys[], surface_axis_keys[],
    surface_radius_keys[];

/* For `wrong`: of a normal or an axis, and of a radius. */
const char *surface_wrong_direction(const struct surface *s);
const char *surface_wrong_radius(const struct surface *s);

#endif
