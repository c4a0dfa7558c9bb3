/* contact_points.h -- the points of a surface that touch other bodies.
 * Chapter "Resolving the grains".
 *
 * Two bodies of any shape touch where a point of one is inside the other, whose
 * distance says how deep. The points lie on the triangles of the surface, not
 * farther apart than half of the width of the body: where two edges cross, one
 * of their points is then inside before the edges are a quarter of a width
 * deep.
 */
#ifndef RESOLVED_SHAPES_CONTACT_POINTS_H
#define RESOLVED_SHAPES_CONTACT_POINTS_H

#include "resolved/body_outline.h"

/* Adds them as balls of radius 0 to an outline that has triangles, and sets
 * how many of them lie in one plane at most. */
void contact_points_add(struct body_outline *o);

/* Of one that reaches from wall to wall along axis k: in the middle between the
 * walls, as the outline there; of a round one a single ball of its radius. */
void contact_points_between(struct body_outline *o, int k);

#endif
