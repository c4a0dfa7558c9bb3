/* fast.h -- the fast method: neighbour lists, chunks and vector loops.
 * The chapters Neighbours and Fast particles explain it.
 */
#ifndef DEM_FAST_FAST_H
#define DEM_FAST_FAST_H

#include "dem/dem_method.h"

extern const struct dem_method fast_verlet;

#endif
