/* body_shape.h -- where the surface of a body is.
 * Chapter "Resolving the grains".
 *
 * All that the flow around a body needs of its shape is the distance s of a
 * point from the surface, negative inside.
 */
#ifndef RESOLVED_BODY_SHAPE_H
#define RESOLVED_BODY_SHAPE_H

enum body_shape_kind { SHAPE_SPHERE };

struct body_shape {
    enum body_shape_kind kind;
    double size[3]; /* [m] sphere: the radius */
};

struct body_shape body_shape_sphere(double diameter);

/* Signed distance [m] of the point r [m], seen from the centre of the body. */
double body_shape_distance(const struct body_shape *shape, const double r[3]);

/* Radius of the smallest sphere around the centre that holds the body [m]. */
double body_shape_reach(const struct body_shape *shape);

double body_shape_volume(const struct body_shape *shape); /* [m^3] */

#endif
