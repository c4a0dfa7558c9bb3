/* block_outline.h -- boxes and cylinders that turn. Chapter "Resolving the
 * grains".
 *
 * Their distance is that of body_shape.h in a frame of their own; so they have
 * the flow of the same shape at rest, and moments of inertia besides.
 */
#ifndef RESOLVED_SHAPES_BLOCK_OUTLINE_H
#define RESOLVED_SHAPES_BLOCK_OUTLINE_H

#include "resolved/body_shape.h"

/* A box or a cylinder that was turned by the angle |rotation| [rad] about the
 * direction of `rotation` before time 0; a cylinder has its axis besides. */
struct body_outline *block_outline_create(const struct body_shape *block,
                                          const double rotation[3]);

#endif
