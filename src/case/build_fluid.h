/* build_fluid.h -- the fluid of a simulation and its boundaries. */
#ifndef CASE_BUILD_FLUID_H
#define CASE_BUILD_FLUID_H

#include "coupling/simulation.h"
#include "case/settings.h"

/* 1 if the fluid feels the particles. */
int build_two_way(const struct settings *s);

/* What the case says of the fluid; needs dt and the boundaries. */
struct fluid_options build_fluid_options(const struct settings *s,
                                         const struct simulation *sim);

/* Fills sim->fluid, boundaries and inlet_series; needs mesh and dt. Non-zero
 * after a message. */
int build_fluid(const struct settings *s, struct simulation *sim);

#endif
