/* shapes.h -- the shapes that a body may have besides those of body_shape.h.
 * Chapter "Resolving the grains". */
#ifndef RESOLVED_SHAPES_SHAPES_H
#define RESOLVED_SHAPES_SHAPES_H

#include <math.h>

#include "resolved/body_shape.h"

/* Boxes and cylinders that turn.
 *
 * Their distance is that of body_shape.h in a frame of their own; so they have
 * the flow of the same shape at rest, and moments of inertia besides. */

/* A box or a cylinder that was turned by the angle |rotation| [rad] about the
 * direction of `rotation` before time 0; a cylinder has its axis besides. */
struct body_outline *block_outline_create(const struct body_shape *block,
                                          const double rotation[3]);

/* The surface of a box or a cylinder as triangles.
 *
 * A cylinder becomes a prism of 64 sides whose corners lie on it: it is thinner
 * by 1.2e-3 of the radius in between. */

/* How many triangles there are; 0 for other shapes. */
int block_triangles_count(const struct body_shape *shape);

/* Their corners [m] around the centre; t has room for all. The normals of a
 * box and of the ends of a cylinder may be inward. */
void block_triangles_put(const struct body_shape *shape, const double centre[3],
                         double (*t)[3][3]);

/* Spheres that are one body.
 *
 * They may overlap: then the volume is that of their union. */

/* n spheres where they were given [m]; those of the outline are seen from its
 * centroid. */
struct body_outline *clump_create(int n, const struct body_ball *ball);

/* A body within a closed surface of triangles.
 *
 * The distance of a point is that of the nearest triangle. Its sign is that of
 * the angle with the normal in the nearest point: of the triangle, of an edge
 * the sum of both sides, of a corner the sum of all triangles around it, each
 * with its angle there. With these, inside and outside are right for any closed
 * surface without a cut in itself [BA05]. */

/* The corners [m] are copied. NULL if the surface is not closed; then *trouble
 * says in half a sentence why. A surface whose normals all point inward is
 * turned. */
struct body_outline *closed_surface_create(int n, double (*corner)[3][3],
                                           const char **trouble);

/* The points of a surface that touch other bodies.
 *
 * Two bodies of any shape touch where a point of one is inside the other, whose
 * distance says how deep. The points lie on the triangles of the surface, not
 * farther apart than half of the width of the body: where two edges cross, one
 * of their points is then inside before the edges are a quarter of a width
 * deep. */

/* Adds them as balls of radius 0 to an outline that has triangles, and sets
 * how many of them lie in one plane at most. */
void contact_points_add(struct body_outline *o);

/* Of one that reaches from wall to wall along axis k: in the middle between the
 * walls, as the outline there; of a round one a single ball of its radius. */
void contact_points_between(struct body_outline *o, int k);

/* --- triangle tree -------------------------------------------------------- */

/* The nearest of many triangles.
 *
 * A binary tree of boxes: each contains the boxes of its two halves, the last
 * ones a few triangles. A box farther away than the nearest triangle so far is
 * passed over with all that is in it. */

struct triangle_tree;

/* Square of the distance of y from a box along the first n axes; 0 inside. */
static inline double box_apart(int n, const double *y, const double lo[3],
                               const double hi[3])
{
    double square = 0.0;

    for (int k = 0; k < n; k++) {
        const double out = fmax(fmax(lo[k] - y[k], y[k] - hi[k]), 0.0);
        square += out * out;
    }
    return square;
}

/* It belongs to the owner (base/alloc.h); the corners [m] are borrowed. */
struct triangle_tree *triangle_tree_create(void *owner, int n,
                                           double (*corner)[3][3]);

/* The triangle nearest to y [m], and q, its point that is. To begin with `near`
 * saves time, if that is one not far away. */
int triangle_tree_nearest(const struct triangle_tree *t, const double y[3],
                          int near, double q[3]);

/* Goes into the boxes, from lo to hi [m], and calls `act` for what is in the
 * smallest ones. Of two halves the one with the lower rank is first; those of
 * rank HUGE_VAL are passed over. */
struct triangle_tree_search {
    double (*rank)(void *by, const double lo[3], const double hi[3]);
    void (*act)(void *by, int i);
};
void triangle_tree_walk(const struct triangle_tree *t,
                        const struct triangle_tree_search *search, void *by);

#endif
