/* effect_force.h -- forces of the fluid on particles, for effects.
 * Chapter "Further forces". */
#ifndef COUPLING_EFFECTS_EFFECT_FORCE_H
#define COUPLING_EFFECTS_EFFECT_FORCE_H

#include "coupling/simulation.h"

/* Adds a force f [N] of the fluid on particle i for the sub-step that follows,
 * and its impulse. For effects, before a sub-step. */
void effect_force_add(struct simulation *sim, int i, const double f[3]);

/* For an effect whose force on a particle contains m du/dt. The first allocates
 * the arrays `inertia` and `u_before`, with which the next step of the fluid
 * contains a share of the reaction to m (u^new - u_before)/dt in advance
 * (reaction.h), and the step after it the rest; with the explicit treatment
 * nothing is in advance. The second adds m [kg] of particle i, after the
 * particles have moved, for the step of the fluid that follows. */
void effect_force_inertia(struct simulation *sim);
void effect_force_charge(struct simulation *sim, int i, double m);

#endif
