/* build.h -- from a checked case to a simulation at time 0. */
#ifndef CASE_BUILD_H
#define CASE_BUILD_H

#include "coupling/simulation.h"
#include "case/build_free.h"
#include "case/settings.h"

struct bed_saver;

/* The simulation that the case describes, its bed settled. NULL after a
 * message; *code is then 2, 3 (the bed did not settle) or 4. */
struct simulation *build_simulation(const struct settings *s, int *code);
/* The same for a run. If with_bed is 0, there is only memory for the bed, whose
 * state will be loaded. The saver, borrowed or NULL, saves the bed while it
 * settles and may end the settling with a code of its own (bed_settling.h). */
struct simulation *build_for_run(const struct settings *s, int with_bed,
                                 const struct bed_saver *saver, int *code);

/* The averaging and the drag law that the case chooses. */
struct averaging_options build_averaging_options(const struct settings *s);
struct drag_law build_drag_law(const struct settings *s);

/* The drag and the effects; mesh, particles and averaging must be there. */
void build_coupling(const struct settings *s, struct simulation *sim);
void build_effects(const struct settings *s, struct simulation *sim);

#endif
