/* attraction_loop.h -- the attractions of a chunk. Chapter "Materials, rolling
 * and cohesion". */
#ifndef DEM_FAST_ATTRACTION_LOOP_H
#define DEM_FAST_ATTRACTION_LOOP_H

#include "dem/attraction.h"
#include "dem/fast/chunk.h"

/* Adds the forces of all pairs and walls of the chunk's neighbour list to its
 * loads. */
void attraction_loop_add(struct chunk *s, const struct bodies *b,
                         const struct attraction *a);

#endif
