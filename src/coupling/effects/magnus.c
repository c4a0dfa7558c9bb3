/* SPDX-License-Identifier: GPL-3.0-or-later */
/* magnus.c -- Magnus's lift on a particle that spins [LS 5.7] (spin.h). */
#include "coupling/coupling.h"
#include "coupling/effects/effect_force.h"
#include "coupling/effect_scales.h"
#include "coupling/effects.h"
#include "coupling/effects/spin.h"
#include "coupling/effects/vorticity.h"

static void *magnus_create(struct simulation *sim, const double *parameters)
{
    (void)parameters;
    return vorticity_create(sim, "magnus_vorticity");
}

/* The lift for slip and spin at the start of the sub-step. */
static void magnus_before_substep(void *memory, struct simulation *sim)
{
    const struct vorticity *const v = memory;
    const struct fluid_options *const o = &sim->fluid->options;
    const struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        double w[3], Omega[3], F[3];
        coupling_slip(sim, i, w);
        vorticity_relative_spin(v, ps, i, Omega);
        spin_lift(o->rho, o->mu, ps->d[i], w, Omega, F);
        effect_force_add(sim, i, F);
    }
}

static struct effect_estimate magnus_estimate(const struct effect_scales *k)
{
    const double Re = k->rho_f * k->slip * k->d / k->mu;
    const double Re_r = spin_reynolds(k->rho_f, k->mu, k->d, k->spin);
    const double F =
        spin_force(k->rho_f, spin_lift_coefficient(Re, Re_r), k->d, k->slip);

    return (struct effect_estimate){Re > 0.0 && Re_r > 0.0 ? F / k->force : 0.0,
                                    "with the spin that collisions leave", 0};
}

static const struct key keys[] = {{"effects.magnus", KEY_GROUP, "", "",
                                   KEY_OPTIONAL,
                                   "lift on a particle that rotates", "LS 5.7",
                                   "fluid particles averaging exchange"},
                                  {0}};

const struct effect magnus_effect = {
    .name = "magnus",
    .what = "lift on a particle that rotates",
    .equations = "LS 5.7",
    .function = "spin_lift",
    .keys = {keys},
    .create = magnus_create,
    .before_particles = vorticity_update,
    .before_substep = magnus_before_substep,
    .free = vorticity_free,
    .estimate = magnus_estimate,
    .cost = {89.0, 65.0, 0.0},
};
