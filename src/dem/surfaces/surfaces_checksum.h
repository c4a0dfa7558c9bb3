/* surfaces_checksum.h -- the checksum of the surfaces that a bed rests on.
 * Chapter "Nothing is lost".
 */
#ifndef DEM_SURFACES_SURFACES_CHECKSUM_H
#define DEM_SURFACES_SURFACES_CHECKSUM_H

#include "dem/dem_options.h"

/* CRC-32 over the shapes of the surfaces at time 0, their triangles and what
 * material 0 is against theirs; 0 if there are no surfaces. */
unsigned long surfaces_checksum(const struct dem_options *o);

#endif
