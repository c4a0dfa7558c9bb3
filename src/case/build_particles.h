/* build_particles.h -- the particles of a case, at rest or placed. */
#ifndef CASE_BUILD_PARTICLES_H
#define CASE_BUILD_PARTICLES_H

#include "coupling/simulation.h"
#include "dem/bed.h"
#include "case/settings.h"

/* Sets sim->particles, dem and held_force; sim->mesh, dt and dem_steps must be
 * set. If with_bed is 0, there is only memory for the particles of the bed. The
 * saver may be NULL. Returns the exit code, after a message if it is not 0. */
int build_particles(const struct settings *s, struct simulation *sim,
                    int with_bed, const struct bed_saver *saver);

/* Whether the particles can be created where the case places them, those of a
 * bed on its lattice: 0, or the exit code after a message. Nothing moves. */
int build_particles_check(const struct settings *s);

/* Sets the overlap that the case expects and the largest that it allows. */
void build_particles_limit(const struct settings *s, struct simulation *sim);

#endif
