/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fluid_torque.c -- the torque of the fluid on a particle that spins (spin.h).
 *
 *   I domega/dt = T,   omega - curl u/2 = Omega ~ exp(-r t)
 *
 * r is taken from the start of a sub-step of the drag, and the exponential is
 * stable for any sub-step. The reaction does not act on the fluid: averaged
 * over the cell a couple is no force, and the angular momentum of the fluid
 * below the size of a cell is not in the equations.
 */
#include <math.h>

#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/effect_scales.h"
#include "coupling/effects.h"
#include "coupling/effects/spin.h"
#include "coupling/effects/vorticity.h"

static void *fluid_torque_create(struct simulation *sim,
                                 const double *parameters)
{
    (void)parameters;
    return vorticity_create(sim, "fluid_torque_vorticity");
}

static void fluid_torque_before_substep(void *memory, struct simulation *sim)
{
    const struct vorticity *const v = memory;
    const struct fluid_options *const o = &sim->fluid->options;
    struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        double *const spin[3] = {&ps->wx[i], &ps->wy[i], &ps->wz[i]};
        const double rho_s = ps->m[i] / particles_volume(ps, i);
        double Omega[3];
        vorticity_relative_spin(v, ps, i, Omega);
        const double rate = spin_decay_rate(o->rho, o->mu, ps->d[i], rho_s,
                                            vector_length(Omega));
        for (int k = 0; k < 3; k++)
            *spin[k] += Omega[k] * expm1(-rate * sim->substep);
    }
}

static struct effect_estimate
fluid_torque_estimate(const struct effect_scales *k)
{
    const double rate =
        spin_decay_rate(k->rho_f, k->mu, k->d, k->rho_s, k->spin);

    return (struct effect_estimate){
        k->spin > 0.0 ? -expm1(-rate * k->tau) : 0.0,
        "of a spin is lost in a relaxation time", 1};
}

static const struct key keys[] = {
    {"effects.fluid_torque", KEY_GROUP, "", "", KEY_OPTIONAL,
     "torque of the fluid, which slows the rotation of a particle", "LS 5.7",
     "fluid particles averaging exchange"},
    {0}};

const struct effect fluid_torque_effect = {
    .name = "fluid_torque",
    .what = "torque of the fluid on a particle that rotates",
    .equations = "",
    .function = "spin_decay_rate",
    .keys = {keys},
    .create = fluid_torque_create,
    .before_particles = vorticity_update,
    .before_substep = fluid_torque_before_substep,
    .free = vorticity_free,
    .estimate = fluid_torque_estimate,
    .cost = {36.0, 66.0, 0.0},
};
