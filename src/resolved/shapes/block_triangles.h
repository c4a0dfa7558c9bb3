/* block_triangles.h -- the surface of a box or a cylinder as triangles.
 * Chapter "Resolving the grains".
 *
 * A cylinder becomes a prism whose corners lie on it: with `sides` of them it
 * is thinner by 1 - cos(pi / sides) of the radius in between.
 */
#ifndef RESOLVED_SHAPES_BLOCK_TRIANGLES_H
#define RESOLVED_SHAPES_BLOCK_TRIANGLES_H

#include "resolved/body_shape.h"

/* How many triangles there are: 12, or 4 a side of the prism. */
int block_triangles_count(const struct body_shape *shape, int sides);

/* Their corners [m] around the centre; t has room for all. The normals of a
 * box and of the ends of a cylinder may be inward. */
void block_triangles_put(const struct body_shape *shape, int sides,
                         const double centre[3], double (*t)[3][3]);

#endif
