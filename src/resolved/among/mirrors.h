/* mirrors.h -- the surface of the bodies as a wall to the averaging.
 * Chapter "Resolving the grains".
 *
 * What a method of averaging puts into a cell of a body, at the depth s below
 * its surface, is moved out to the place as far before it, its mirror image: at
 * a plane wall nothing would then flow through the surface [SX15 5c]. Sums of
 * volume, momentum and force stay [SX15 A.1]. A field is continued into the
 * body by the same weights: an image has the value of what it mirrors.
 */
#ifndef RESOLVED_AMONG_MIRRORS_H
#define RESOLVED_AMONG_MIRRORS_H

#include "averaging/averaging.h"
#include "resolved/solid_bodies.h"

struct mirrors;

struct mirrors *mirrors_create(const struct mesh *mesh);
void mirrors_free(struct mirrors *m);

/* The bodies have moved. */
void mirrors_update(struct mirrors *m, const struct solid_bodies *b);

/* Borrowed. */
struct averaging_wall *mirrors_wall(struct mirrors *m);

/* Cells whose contents have nowhere to go, because no open one is near [-]. */
int mirrors_stuck(const struct mirrors *m);

#endif
