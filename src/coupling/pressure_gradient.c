/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pressure_gradient.c -- the two forces on a particle that need no flow around
 * it: its weight, and the mean pressure on its surface. */
#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "coupling/simulation.h"

#include <gsl/gsl_math.h>
#include <stddef.h>

/* --- gravity -------------------------------------------------------------- */

/* The weight of the particles, m g [XS11 2.1].
 *
 * The weight of the fluid balances the hydrostatic part of the pressure, which
 * fluid.h leaves out. That part acts on the whole volume; where the phases do
 * not share the pressure (pressure_shared in fluid.h is 0), reaction.c takes
 * the difference, eps_s rho_f g, from the force F on the fluid: F gets
 * -(1 - eps) rho_f g. */

static void *gravity_create(struct simulation *sim, const double *parameters)
{
    for (int k = 0; k < 3; k++)
        sim->gravity[k] = parameters[k];
    return NULL;
}

static void gravity_range(int first, int last, struct simulation *sim,
                          const void *memory, struct effect_tally *tally)
{
    (void)memory;
    for (int i = first; i < last; i++) {
        double f[3];
        for (int k = 0; k < 3; k++) {
            f[k] = sim->particles->m[i] * sim->gravity[k];
            sim->held_force[3 * i + k] += f[k];
        }
        effects_tally_add(tally, vector_length(f), 1.0);
    }
}

static void gravity_before_particles(void *memory, struct simulation *sim)
{
    effects_report_all(sim, gravity_range, memory);
}

static struct effect_estimate gravity_estimate(const struct effect_scales *k)
{
    return effects_estimate(k->weight / k->force, "");
}

static const struct key gravity_keys[] = {
    {"effects.gravity", KEY_VECTOR, "m/s^2", "", KEY_OPTIONAL,
     "acceleration by gravity: the weight of the particles", "XS11 2.1",
     "particles|bodies", KEY_AT(effects_options, gravity),
     KEY_GIVEN(effects_options, has_gravity), .divided = KEY_DIVIDED},
    KEY_END};

const struct effect gravity_effect = {
    .name = "gravity",
    .what = "weight of the particles",
    .equations = "XS11 2.1",
    .function = "gravity_before_particles",
    .keys = {gravity_keys},
    .create = gravity_create,
    .before_particles = gravity_before_particles,
    .estimate = gravity_estimate,
    .cost = {7.0, 0.0, 0.0},
};

/* --- pressure gradient ---------------------------------------------------- */

/* The pressure on the surface of a particle,
 *
 *   f_i = -V_p (grad p + rho_f g)       [LS 5.1, XS11 2.6, first term]
 *
 * p is without its hydrostatic part, whose force is the buoyancy. The gradient
 * at a particle is interpolated by the adjoint of the averaging, so that the
 * sum of all f_i is, to rounding, the force eps_s grad p that is missing in the
 * fluid's equation (gamma = eps in fluid.h), and the exchange of momentum is
 * exact and immediate: model A. In model B the whole grad p acts on the fluid,
 * and the reaction of f_i acts on it like the drag, in the next step [SX15 2b,
 * EW18 11]. */

struct pressure_gradient {
    double *gradient; /* [Pa/m] at the particles, 3 each */
};

static void *pressure_gradient_create(struct simulation *sim,
                                      const double *parameters)
{
    struct pressure_gradient *const self = owner_create(sizeof *self);
    (void)parameters;
    self->gradient = owner_doubles(self, 3 * sim->particles->capacity);
    return self;
}

/* Model B: the reaction of the force acts on the fluid. The fluid carries the
 * weight of the solids in eps_s, so the reaction to buoyancy is that of these
 * and not of the volume above a cap. */
static void add_reaction(struct simulation *sim, int i, double V,
                         double impulse[3])
{
    const double out = 1.0 - averaging_capped_fraction(sim->averaging, i);
    const double rho = sim->fluid->options.rho;

    for (int k = 0; k < 3; k++)
        impulse[k] += out * V * rho * sim->gravity[k] * sim->dt;
    coupling_add_impulse(sim, i, impulse);
}

/* Model A in the first step of BDF2: the fluid receives more than the reaction,
 * and gives the rest back. */
static void pressure_gradient_add_rest(struct simulation *sim, int i, double V,
                                       const double gradient[3])
{
    double impulse[3];

    for (int k = 0; k < 3; k++)
        impulse[k] = V * gradient[k] * sim->dt;
    coupling_add_impulse(sim, i, impulse);
}

static void pressure_gradient_range(int first, int last, struct simulation *sim,
                                    const void *memory,
                                    struct effect_tally *tally)
{
    const struct pressure_gradient *const self = memory;
    const double rho = sim->fluid->options.rho;
    const int shared = sim->fluid->options.pressure_shared;
    const double weight = sim->fluid->impulse_weight;

    for (int i = first; i < last; i++) {
        const double V = particles_volume(sim->particles, i);
        double f[3], impulse[3];
        for (int k = 0; k < 3; k++) {
            f[k] = -V * (self->gradient[3 * i + k] + rho * sim->gravity[k]);
            sim->held_force[3 * i + k] += f[k];
            impulse[k] = f[k] * sim->dt;
        }
        effects_tally_add(tally, vector_length(f), 1.0);
        if (!shared)
            add_reaction(sim, i, V, impulse);
        else if (weight != 1.0)
            pressure_gradient_add_rest(sim, i, (weight - 1.0) * V,
                                       &self->gradient[3 * i]);
    }
}

/* The pressure part of [LS 5.1, XS11 2.6]. The solved p acts only on the part
 * of a particle that is in eps_s: see averaging_apply_cap. */
static void pressure_gradient_before_particles(void *memory,
                                               struct simulation *sim)
{
    const struct pressure_gradient *const self = memory;

    averaging_gather(sim->averaging, 3, sim->fluid->grad_p, self->gradient);
    averaging_apply_cap(sim->averaging, 3, self->gradient);
    effects_report_all(sim, pressure_gradient_range, self);
}

/* In a fluidized bed this force is eps_s + eps_f rho_f/rho_s of the weight, on
 * a lone particle the buoyancy. In a bed that is not fluidized the gradient is
 * that of the drag, eps_s beta w. A stream that changes in time has its own.
 * Where a period lets the fluid go along with the drag on it, there is none in
 * the mean: what is left, of an uneven bed, is less. An averaging that is wide
 * against the bed lets the stream meet less of it (passed). */
static struct effect_estimate
pressure_gradient_estimate(const struct effect_scales *k)
{
    const double V = M_PI / 6.0 * k->d * k->d * k->d;
    const double steady =
        V * (k->mean_gradient + k->rho_f * (k->gravity + k->changes));
    const double of_drag = k->passed * k->drag / (1.0 - k->passed);
    struct effect_estimate e;

    if (k->held || steady > 0.0)
        return effects_estimate((steady + k->held * of_drag) / k->force, "");
    e = effects_unknown(of_drag / k->force, "the fluid is free to go along");
    e.bound = 1;
    return e;
}

static const struct key pressure_gradient_keys[] = {
    {"effects.pressure_gradient", KEY_GROUP, "", "", KEY_OPTIONAL,
     "force of the pressure gradient, with buoyancy, on the particles",
     "LS 5.1, XS11 2.6", "fluid particles averaging exchange",
     KEY_GIVEN(effects_options, pressure_gradient), .divided = KEY_DIVIDED},
    KEY_END};

const struct effect pressure_gradient_effect = {
    .name = "pressure_gradient",
    .what = "force of the pressure gradient and buoyancy",
    .equations = "LS 5.1, XS11 2.6, XS11 2.8",
    .function = "pressure_gradient_before_particles",
    .keys = {pressure_gradient_keys},
    .create = pressure_gradient_create,
    .before_particles = pressure_gradient_before_particles,
    .estimate = pressure_gradient_estimate,
    .cost = {16.0, 17.0, 0.0},
};
