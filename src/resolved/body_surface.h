/* body_surface.h -- the surface of a body as particles touch it.
 * Chapter "Resolving the grains".
 */
#ifndef RESOLVED_BODY_SURFACE_H
#define RESOLVED_BODY_SURFACE_H

#include "dem/surfaces/surface.h"
#include "resolved/solid_bodies.h"

/* Of body i where it is: a sphere, a cylinder without ends where it reaches
 * through the box, else triangles. */
struct surface body_surface(const struct solid_bodies *b, int i);
void body_surface_release(struct surface *s);

#endif
