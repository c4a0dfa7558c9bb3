/* SPDX-License-Identifier: GPL-3.0-or-later */
/* gravity.c -- the weight of the particles, m g [XS11 2.1].
 *
 * The weight of the fluid balances the hydrostatic part of the pressure, which
 * fluid.h leaves out. That part acts on the whole volume; where the phases do
 * not share the pressure (pressure_shared in fluid.h is 0), reaction.c takes
 * the difference, eps_s rho_f g, from the force F on the fluid: F gets
 * -(1 - eps) rho_f g.
 */
#include "coupling/effect_scales.h"
#include "coupling/effects.h"

#include <stddef.h>

#include "coupling/simulation.h"

static void *gravity_create(struct simulation *sim, const double *parameters)
{
    for (int k = 0; k < 3; k++)
        sim->gravity[k] = parameters[k];
    return NULL;
}

static void gravity_before_particles(void *memory, struct simulation *sim)
{
    (void)memory;
    for (int i = 0; i < sim->particles->n; i++) {
        double f[3];
        for (int k = 0; k < 3; k++) {
            f[k] = sim->particles->m[i] * sim->gravity[k];
            sim->held_force[3 * i + k] += f[k];
        }
        effects_report(sim, f, 1.0);
    }
}

static struct effect_estimate gravity_estimate(const struct effect_scales *k)
{
    return (struct effect_estimate){k->weight / k->force, "", 0};
}

static const struct key keys[] = {
    {"effects.gravity", KEY_VECTOR, "m/s^2", "", KEY_OPTIONAL,
     "acceleration by gravity: the weight of the particles", "XS11 2.1",
     "particles|bodies", .at = KEY_AT(effects_options, gravity),
     .given = KEY_AT(effects_options, has_gravity), .divided = KEY_DIVIDED},
    {0}};

const struct effect gravity_effect = {
    .name = "gravity",
    .what = "weight of the particles",
    .equations = "XS11 2.1",
    .function = "gravity_before_particles",
    .keys = {keys},
    .create = gravity_create,
    .before_particles = gravity_before_particles,
    .estimate = gravity_estimate,
    .cost = {7.0, 0.0, 0.0},
};
