/* effects.h -- the list of all effects, and the calls of those of a case.
 * Chapter "The coupled loop".
 *
 * The forces of the effects are measured in every step, and with them what they
 * are compared with: the largest of a particle's weight, its drag and the push
 * of the gradient that drives the fluid.
 */
#ifndef COUPLING_EFFECTS_H
#define COUPLING_EFFECTS_H

#include "coupling/effect.h"
#include "coupling/simulation.h"

/* What a case says of the effects that others than these ask for. */
struct effects_options {
    double gravity[3]; /* [m/s^2] 0 unless the case names it */
    /* [-] 1: the case names it */
    int has_gravity, pressure_gradient, time_average, van_der_waals, capillary,
        particle_stress;
    double mixing_sample; /* [m] 0: the case does not name the effect */
};

extern const struct key effects_keys[]; /* the group of all */

extern const struct effect gravity_effect;
extern const struct effect pressure_gradient_effect;

/* All of them, ended by NULL, and the one of that name or NULL. */
extern const struct effect viscous_stress_effect, virtual_mass_effect,
    basset_effect, saffman_effect, fluid_torque_effect, magnus_effect,
    time_average_effect, energy_budget_effect, cohesion_electrostatic,
    cohesion_van_der_waals, cohesion_capillary, whole_drag_effect,
    stochastic_drag_effect, lubrication_effect, bubbles_effect, mixing_effect,
    particle_stress_effect, collision_damping_effect, collision_isotropy_effect;
extern const struct effect *const effects[];
const struct effect *effect_named(const char *name);

/* Creates an effect of these parameters and adds it; meanwhile it is
 * sim->running_effect. */
void effects_create(struct simulation *sim, const struct effect *e,
                    const double *parameters);

/* Adds an active effect to the simulation, which frees its memory. */
void effects_add(struct simulation *sim, const struct effect *e, void *memory);

/* The memory of that effect; NULL if it is not active. */
void *effects_memory(const struct simulation *sim, const struct effect *e);

/* Frees the effects of a case with their memory. */
void effects_free(struct simulation *sim);

/* The stages of a step at which effects are called (effect.h). */
enum effects_stage {
    EFFECTS_BEFORE_PARTICLES,
    EFFECTS_BEFORE_SUBSTEP,
    EFFECTS_AFTER_PARTICLES,
    EFFECTS_AFTER_STEP
};

/* Calls the effects of a case that have a hook for this stage, in their order,
 * and measures their time. */
void effects_call(struct simulation *sim, enum effects_stage stage);

/* Reports the force f [N] on one particle of the effect whose hook runs, for
 * this share of the step [-]. Outside of a hook it has no effect. */
void effects_report(struct simulation *sim, const double f[3], double share);

/* The same for all particles at once, by ranges of them (parallel_ranges.h):
 * f(first, last, sim, memory, tally) adds the force of each to a tally of its
 * range, and those are added in order. */
typedef void effects_range(int first, int last, struct simulation *sim,
                           const void *memory, struct effect_tally *tally);
void effects_report_all(struct simulation *sim, effects_range *f,
                        const void *memory);
void effects_tally_add(struct effect_tally *t, double size, double share);

/* Measures the scale at the end of a step. */
void effects_measure_scale(struct simulation *sim);

/* Forces of the fluid on particles, for effects. */

/* Adds a force f [N] of the fluid on particle i for the sub-step that follows,
 * and its impulse. For effects, before a sub-step. */
void effect_force_add(struct simulation *sim, int i, const double f[3]);

/* For an effect whose force on a particle contains m du/dt. The first allocates
 * the arrays `inertia` and `u_before`, with which the next step of the fluid
 * contains a share of the reaction to m (u^new - u_before)/dt in advance
 * (transfer.h), and the step after it the rest; with the explicit treatment
 * nothing is in advance. The second adds m [kg] of particle i, after the
 * particles have moved, for the step of the fluid that follows. */
void effect_force_inertia(struct simulation *sim);
void effect_force_charge(struct simulation *sim, int i, double m);

/* An estimate that is known, of the force on a grain; and one that is not, at
 * most so large, with what would tell. */
struct effect_estimate effects_estimate(double share, const char *remark);
struct effect_estimate effects_unknown(double most, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
