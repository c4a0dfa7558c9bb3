/* particle_options.h -- the particles of a case as the options from which dem
 * and its bed are created.
 */
#ifndef CASE_PARTICLE_OPTIONS_H
#define CASE_PARTICLE_OPTIONS_H

#include "dem/bed.h"
#include "case/settings.h"

/* The options of dem for particle steps of this length [s]. */
struct dem_options particle_options_dem(const struct settings *s, double step);

/* The options of the bed, where the case has one; the second function releases
 * its sizes. */
struct bed_options particle_options_bed(const struct settings *s);
void particle_options_release(struct bed_options *b);

/* The largest overlap of a placed sphere with a wall of the box, over its
 * diameter [-]:
 * 0.01, and up to its centre where particles.overlaps is "allow". */
double particle_options_wall_overlap(const struct settings *s);

#endif
