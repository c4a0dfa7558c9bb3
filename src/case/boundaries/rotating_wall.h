/* rotating_wall.h -- a wall that rotates about an axis. */
#ifndef CASE_BOUNDARIES_ROTATING_WALL_H
#define CASE_BOUNDARIES_ROTATING_WALL_H

#include "case/settings.h"
#include "fluid/boundary.h"

/* Makes the boundary of a patch a wall that rotates as the case says. 0, or 2
 * after a message: the wall would move through itself. */
int rotating_wall_add(const struct settings *s, const struct mesh *m,
                      const struct patch *p, struct boundary *b);

#endif
