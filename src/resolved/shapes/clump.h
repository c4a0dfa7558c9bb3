/* clump.h -- spheres that are one body. Chapter "Resolving the grains".
 *
 * They may overlap: then the volume is that of their union.
 */
#ifndef RESOLVED_SHAPES_CLUMP_H
#define RESOLVED_SHAPES_CLUMP_H

#include "resolved/body_outline.h"

/* n spheres where they were given [m]; those of the outline are seen from its
 * centroid. */
struct body_outline *clump_create(int n, const struct body_ball *ball);

#endif
