/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/effect_force.h"

#include "base/alloc.h"
#include "coupling/coupling.h"
#include "coupling/effects.h"

void effect_force_add(struct simulation *sim, int i, const double f[3])
{
    const double T = sim->substep, impulse[3] = {f[0] * T, f[1] * T, f[2] * T};

    sim->particles->ex[i] += f[0];
    sim->particles->ey[i] += f[1];
    sim->particles->ez[i] += f[2];
    coupling_add_impulse(sim, i, impulse);
    effects_report(sim, f, T / sim->dt);
}

void effect_force_inertia(struct simulation *sim)
{
    struct coupling *const cp = sim->coupling;

    if (cp->inertia != NULL) return;
    cp->inertia = alloc_doubles(sim->particles->capacity);
    cp->u_before = alloc_doubles(3 * sim->particles->capacity);
    particles_attach(sim->particles, "inertia", "kg", cp->inertia, 1);
    particles_attach(sim->particles, "u_before", "m/s", cp->u_before, 3);
}

void effect_force_charge(struct simulation *sim, int i, double m)
{
    struct coupling *const cp = sim->coupling;

    if (cp->options.treatment != TREATMENT_SEMI_IMPLICIT ||
        !cp->options.two_way)
        return;
    cp->inertia[i] += m;
    for (int a = 0; a < 3; a++)
        cp->u_before[3 * i + a] = cp->u_f[3 * i + a];
}
