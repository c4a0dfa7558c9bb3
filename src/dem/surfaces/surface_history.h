/* surface_history.h -- the springs of surfaces among all springs.
 *
 * Chapter "Walls".
 *
 * They stand at the end of the list that dem_histories gives.
 */
#ifndef DEM_SURFACES_SURFACE_HISTORY_H
#define DEM_SURFACES_SURFACE_HISTORY_H

#include "dem/dem.h"
#include "dem/surfaces/surfaces.h"

/* Their number; written to the list unless it is NULL. Of the particles ps, or
 * NULL for those that the next run starts with. No surfaces, no springs. */
int surface_history_list(struct surfaces *sf, const struct particles *ps,
                         struct dem_history *list);

/* The next run starts with those at the end of the list of n: their number. */
int surface_history_restore(struct surfaces *sf, const struct dem_history *list,
                            int n);

#endif
