/* build_particles.h -- the particles of a case, at rest or placed. */
#ifndef CASE_BUILD_PARTICLES_H
#define CASE_BUILD_PARTICLES_H

#include "coupling/simulation.h"
#include "dem/bed.h"
#include "case/settings.h"

/* Fills sim->particles, dem and held; needs mesh, dt and dem_steps. Without its
 * bed there is room for it only; the saver of the bed may be NULL. Returns the
 * exit code, after a message if not 0. */
int build_particles(const struct settings *s, struct simulation *sim,
                    int with_bed, const struct bed_saver *saver);

/* 0 if they can be where the case puts them, a bed on its lattice; nothing
 * moves, and nothing is kept. */
int build_particles_check(const struct settings *s);

/* The overlaps that the case expects and allows. */
void build_particles_limit(const struct settings *s, struct simulation *sim);

#endif
