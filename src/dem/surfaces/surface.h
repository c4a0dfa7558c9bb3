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

#include "base/model.h"
#include "dem/particles.h"
#include "dem/surfaces/motion.h"
#include "dem/surfaces/triangles.h"
#include "dem/surfaces/wear.h"

/* the descriptor of a shape that a surface can have.
 *
 * A shape is one file with one descriptor. Its solid is where the distance r is
 * negative: a particle whose centre is there is pushed out, along n. */

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

struct surface {
    const char *name; /* borrowed */
    const struct surface_shape *shape;
    int material;     /* [-] number of it */
    double point[3];  /* [m] on the plane, on the axis; or centre */
    double normal[3]; /* [-] out of the solid; or the axis */
    double radius;    /* [m] of cylinder, sphere */
    int inside;       /* [-] 1: particles are within it */
    struct wear_of wear;
    double own[MODEL_NUMBERS]; /* of the keys that the shape alone reads */
    const struct triangles *triangles; /* borrowed; NULL of other shapes */
    struct motion motion;              /* the places above are of time 0 */
    struct motion_load load;
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
    int has_load;                /* [-] 1: of.load.force is given */
    struct motion_course course;
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

/* --- surface start: particles that begin in a wall. */

/* Non-zero after a message if one of the particles overlaps a surface, as it is
 * at time 0, by more than a tenth of its radius; `where` is before the message.
 */
int surface_start_wrong(const struct particles *ps, const struct surface *list,
                        int n, const char *where);

/* Distance of x from the surface, where it is at time t [s], or R if it is
 * farther [m]; below 0 in the solid of a shape. */
double surface_distance(const struct surface *s, double t, const double x[3],
                        double R);

#endif
