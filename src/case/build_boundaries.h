/* build_boundaries.h -- the boundaries of the fluid, from the keys of a case.
 */
#ifndef CASE_BUILD_BOUNDARIES_H
#define CASE_BUILD_BOUNDARIES_H

#include "fluid/boundary.h"
#include "fluid/inlet_profile.h"
#include "mesh/mesh.h"
#include "case/settings.h"

/* One boundary a patch, of a whole mesh; the times and velocities of all inlets
 * are in *series. Both are freed by build_boundaries_free. */
struct boundary *build_boundaries(const struct settings *s,
                                  const struct mesh *m, double **series);
void build_boundaries_free(struct boundary *all, int n, double *series);

/* 1 if the case gives a key of a patch, whose path this makes. */
enum { BUILD_BOUNDARIES_PATH = 128 };
int build_boundaries_has(const struct settings *s, const struct patch *p,
                         const char *key, char path[BUILD_BOUNDARIES_PATH]);

/* The profile of an inlet, and the times of a run, besides 0, at which one that
 * varies is looked at. */
enum { BUILD_BOUNDARIES_TIMES = 64 };
const struct inlet_profile *build_boundaries_profile(const struct settings *s,
                                                     const struct patch *p);

#endif
