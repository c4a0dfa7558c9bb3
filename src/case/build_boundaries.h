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

/* 0 if all boundaries can be built; else 2 after a message. */
int build_boundaries_check(const struct settings *s);

/* The velocity of an inlet over what the case gives, as its profile makes it
 * [-]: the mean over the patch and the largest of a face, at any time of the
 * run. */
void build_boundaries_shares(const struct settings *s, const char *patch,
                             double *mean, double *peak);

#endif
