/* particle_options.h -- what a case says about its particles, in the numbers
 * that dem and its bed are created from.
 */
#ifndef CASE_PARTICLE_OPTIONS_H
#define CASE_PARTICLE_OPTIONS_H

#include "dem/bed.h"
#include "case/settings.h"

/* Gravity [m/s^2]; returns whether the case has any. */
int particle_options_gravity(const struct settings *s, double g[3]);

/* For particle steps of that length [s]. */
struct dem_options particle_options_dem(const struct settings *s, double step);

/* Of the bed, where the case has one; its sizes are released. */
struct bed_options particle_options_bed(const struct settings *s);
void particle_options_release(struct bed_options *b);

/* How deep a placed sphere may be in a wall of the box, over its diameter [-]:
 * 0.01, and up to its centre where particles.overlaps is "allow". */
double particle_options_wall_overlap(const struct settings *s);

#endif
