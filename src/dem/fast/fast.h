/* fast.h -- the fast method: neighbour lists, chunks and vector loops.
 * Chapters 3, 18.
 */
#ifndef DEM_FAST_FAST_H
#define DEM_FAST_FAST_H

#include "dem/dem_method.h"

extern const struct dem_method fast_verlet;

#endif
