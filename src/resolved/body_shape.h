/* body_shape.h -- where the surface of a body is.
 * Chapter "Resolving the grains".
 *
 * All that the flow around a body needs of its shape is the distance s of a
 * point from the surface, negative inside.
 */
#ifndef RESOLVED_BODY_SHAPE_H
#define RESOLVED_BODY_SHAPE_H

#include "resolved/body_outline.h"

enum body_shape_kind { BODY_SPHERE, BODY_BOX, BODY_CYLINDER, BODY_OUTLINE };

struct body_shape {
    enum body_shape_kind kind;
    double half[3]; /* [m] sphere: radius; box: halves of its edges; cylinder:
                       radius and half of the length; outline: of its box */
    double axis[3]; /* [-] of a cylinder, of length 1 */
    struct body_outline *outline; /* borrowed, until it is added to bodies,
                                     which free it; NULL: none of those */
    double turn[3][3];            /* [-] Q of an outline */
    int between; /* [-] bit k: walls across axis k hold a free one upright */
};

struct body_shape body_shape_sphere(double diameter);
struct body_shape body_shape_box(const double size[3]);
/* The axis may have any length but 0. */
struct body_shape body_shape_cylinder(double diameter, double length,
                                      const double axis[3]);
/* 1 if the axis of a cylinder is axis k of the mesh, but for rounding. */
int body_shape_along(const struct body_shape *shape, int k);
/* Not turned yet. */
struct body_shape body_shape_outline(struct body_outline *outline);

/* Signed distance [m] of the point r [m], seen from the centre of the body. */
double body_shape_distance(const struct body_shape *shape, const double r[3]);

/* Its gradient, the outward normal [-] of the surface next to r. */
void body_shape_normal(const struct body_shape *shape, const double r[3],
                       double n[3]);

/* Half of the extent along each axis of the mesh [m]. */
void body_shape_extent(const struct body_shape *shape, double extent[3]);

double body_shape_volume(const struct body_shape *shape); /* [m^3] */

/* The smallest width [m]: of a clump, the diameter of its largest ball; of a
 * closed surface, body_outline.h. */
double body_shape_width(const struct body_shape *shape);

/* How many balls touch others, and ball k: its centre from that of the body, in
 * the frame of the box. Boxes and cylinders have none. */
int body_shape_balls(const struct body_shape *shape);
struct body_ball body_shape_ball(const struct body_shape *shape, int k);

#endif
