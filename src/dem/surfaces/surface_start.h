/* surface_start.h -- particles that begin in a wall.  Chapter "Walls". */
#ifndef DEM_SURFACES_SURFACE_START_H
#define DEM_SURFACES_SURFACE_START_H

#include "dem/particles.h"
#include "dem/surfaces/surface.h"

/* Non-zero after a message if one of the particles overlaps a surface, as it is
 * at time 0, by more than a tenth of its radius; `where` is before the message.
 */
int surface_start_wrong(const struct particles *ps, const struct surface *list,
                        int n, const char *where);

/* Distance of x from the surface, as it is at time 0, or R if it is farther
 * [m]. */
double surface_start_distance(const struct surface *s, const double x[3],
                              double R);

#endif
