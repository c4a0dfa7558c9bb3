/* build.h -- from a checked case to a simulation at time 0. */
#ifndef CASE_BUILD_H
#define CASE_BUILD_H

#include "case/settings.h"
#include "coupling/simulation.h"
#include "dem/bed.h"
#include "fluid/boundary.h"

/* The simulation that the case describes, its bed settled. NULL after a
 * message; *code is then 2, 3 (the bed did not settle) or 4. */
struct simulation *build_simulation(const struct settings *s, int *code);
/* The same for a run. If with_bed is 0, there is only memory for the bed, whose
 * state will be loaded. The saver, borrowed or NULL, saves the bed while it
 * settles and may end the settling with a code of its own (bed_settling.h). */
struct simulation *build_for_run(const struct settings *s, int with_bed,
                                 const struct bed_saver *saver, int *code);

/* Releases a simulation and all that was built for it, also in part; NULL is
 * fine. */
void build_free(struct simulation *sim);

/* The averaging and the drag law that the case chooses. */
struct averaging_options build_averaging_options(const struct settings *s);
struct drag_law build_drag_law(const struct settings *s);

/* The drag and the effects; mesh, particles and averaging must be there. */
void build_coupling(const struct settings *s, struct simulation *sim);
void build_effects(const struct settings *s, struct simulation *sim);

/* The options of the fluid; sim->dt and sim->boundaries must be set. */
struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim);

/* One boundary a patch, of a whole mesh; NULL after a message. Freed by
 * build_boundaries_free. */
struct boundary *build_boundaries(const struct settings *s,
                                  const struct mesh *m);
void build_boundaries_free(struct boundary *all, int n);
/* 0 if all boundaries can be built; else 2 after a message. */
int build_boundaries_check(const struct settings *s);
/* The velocity of an inlet over what the case gives, as its profile makes it
 * [-]: the mean over the patch and the largest of a face, at any time of the
 * run. */
void build_boundaries_shares(const struct settings *s, const char *patch,
                             double *mean, double *peak);

/* --- build_particles.c ---------------------------------------------------- */

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

/* The options of dem for particle steps of this length [s]; those of the bed,
 * where the case has one, whose sizes build_particles_free_bed releases. */
struct dem_options build_particles_dem(const struct settings *s, double step);
struct bed_options build_particles_bed(const struct settings *s);
void build_particles_free_bed(struct bed_options *b);

/* The largest overlap of a placed sphere with a wall of the box, over its
 * diameter [-]: 0.01, and up to its centre where particles.overlaps is "allow".
 */
double build_particles_wall_overlap(const struct settings *s);

#endif
