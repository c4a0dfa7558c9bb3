/* build_boundaries.h -- the boundaries of the fluid, from the keys of a case.
 */
#ifndef CASE_BUILD_BOUNDARIES_H
#define CASE_BUILD_BOUNDARIES_H

#include "fluid/boundary.h"
#include "mesh/mesh.h"
#include "case/settings.h"

/* One boundary a patch, of a whole mesh; NULL after a message. Freed by
 * build_boundaries_free. */
struct boundary *build_boundaries(const struct settings *s,
                                  const struct mesh *m);
void build_boundaries_free(struct boundary *all, int n);

/* 1 if the case gives a key of a patch, whose path this makes. */
enum { BUILD_BOUNDARIES_PATH = 128 };
int build_boundaries_has(const struct settings *s, const struct patch *p,
                         const char *key, char path[BUILD_BOUNDARIES_PATH]);

#endif
