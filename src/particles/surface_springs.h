/* surface_springs.h -- the springs of surfaces among all springs. Chapter 14.
 *
 * They stand at the end of the list that dem_springs gives.
 */
#ifndef SURFACE_SPRINGS_H
#define SURFACE_SPRINGS_H

#include "particles/dem.h"
#include "particles/surfaces.h"

/* Their number; written to the list unless it is NULL. Of the particles ps, or
 * NULL for those that the next run starts with. No surfaces, no springs. */
int surface_springs(struct surfaces *sf, const struct particles *ps,
                    struct dem_spring *list);

/* The next run starts with those at the end of the list of n: their number. */
int surface_springs_recall(struct surfaces *sf, const struct dem_spring *list,
                           int n);

#endif
