/* build_fluid.h -- the fluid of a simulation and its boundaries. */
#ifndef CASE_BUILD_FLUID_H
#define CASE_BUILD_FLUID_H

#include "coupling/simulation.h"
#include "case/settings.h"

/* The options of the fluid; sim->dt and sim->boundaries must be set. */
struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim);

/* Sets sim->fluid and boundaries; sim->mesh and dt must be set.
 * Non-zero after a message. */
int build_fluid(const struct settings *s, struct simulation *sim);

#endif
