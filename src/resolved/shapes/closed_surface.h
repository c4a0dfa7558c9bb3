/* closed_surface.h -- a body within a closed surface of triangles.
 * Chapter "Resolving the grains".
 *
 * The distance of a point is that of the nearest triangle. Its sign is that of
 * the angle with the normal in the nearest point: of the triangle, of an edge
 * the sum of both sides, of a corner the sum of all triangles around it, each
 * with its angle there. With these, inside and outside are right for any closed
 * surface without a cut in itself [BA05].
 */
#ifndef RESOLVED_SHAPES_CLOSED_SURFACE_H
#define RESOLVED_SHAPES_CLOSED_SURFACE_H

#include "resolved/body_outline.h"

/* The corners [m] are copied. NULL if the surface is not closed; then *trouble
 * says in half a sentence why. A surface whose normals all point inward is
 * turned. */
struct body_outline *closed_surface_create(int n, double (*corner)[3][3],
                                           const char **trouble);

#endif
