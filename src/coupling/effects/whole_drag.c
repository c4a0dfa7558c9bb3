/* SPDX-License-Identifier: GPL-3.0-or-later */
/* whole_drag.c -- the drag law gives the whole force of the flow on a particle,
 *
 *   F = F_d / eps_f - V_p rho_f g       [EW18 11-13, A.5]
 *
 * and no force of the solved pressure acts beside it: the form that is often
 * called model B. In a steady, even bed the pressure gradient carries the share
 * eps_s of F, so that F is F_d over eps_f (equation 9.15); the whole gradient
 * then stays with the fluid (gamma = 1 in fluid.h), and the particles keep the
 * buoyancy. Where the flow is not steady or not even, the two forms differ:
 * this one leaves out what the pressure gradient has from the acceleration of
 * the fluid.
 *
 * The drag coefficient is changed before it is used, so that the fluid is
 * charged with the same one. The fluid carries the weight of the solids in
 * eps_s, and gets the buoyancy back for these only (averaging_apply_cap).
 */
#include "coupling/effect_scales.h"
#include "coupling/effects.h"

#include <gsl/gsl_math.h>
#include <stddef.h>

#include "coupling/coupling.h"

static void *whole_drag_create(struct simulation *sim, const double *parameters)
{
    (void)sim;
    (void)parameters;
    return NULL;
}

static void whole_drag_drag(void *memory, struct simulation *sim, double *k)
{
    const double *const eps = sim->coupling->eps;

    (void)memory;
    for (int i = 0; i < sim->particles->n; i++)
        k[i] /= eps[i]; /* [EW18 11, A.5] */
}

static void whole_drag_before_particles(void *memory, struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const struct coupling *const cp = sim->coupling;
    const double rho = sim->fluid->options.rho;

    (void)memory;
    for (int i = 0; i < ps->n; i++) {
        const double V = M_PI / 6.0 * gsl_pow_3(ps->d[i]);
        const double within = averaging_capped_fraction(sim->averaging, i);
        const double more = (1.0 - cp->eps[i]) * cp->rate[i]; /* [kg/s] */
        double f[3], impulse[3], w[3];
        coupling_slip(sim, i, w);
        for (int a = 0; a < 3; a++) {
            f[a] = -V * rho * sim->gravity[a]; /* in [EW18 13] */
            sim->held_force[3 * i + a] += f[a];
            impulse[a] = within * f[a] * sim->dt;
            f[a] += more * w[a]; /* what it adds to the drag is its share too */
        }
        effects_report(sim, f, 1.0);
        coupling_add_impulse(sim, i, impulse);
    }
}

/* What it adds to the drag, and the buoyancy. */
static struct effect_estimate whole_drag_estimate(const struct effect_scales *k)
{
    const double V = M_PI / 6.0 * gsl_pow_3(k->d);

    return (struct effect_estimate){
        (k->drag * k->eps_s / (1.0 - k->eps_s) + V * k->rho_f * k->gravity) /
            k->force,
        "in place of the pressure gradient", 1};
}

static const struct key keys[] = {
    {"effects.whole_drag", KEY_GROUP, "", "", KEY_OPTIONAL,
     "the drag law divided by eps_f, and buoyancy, in place of the pressure "
     "gradient",
     "EW18 11-13, A.5",
     "fluid particles averaging exchange !effects.pressure_gradient"},
    {0}};

const struct effect whole_drag_effect = {
    .name = "whole_drag",
    .what = "the drag law as the whole force, without a pressure gradient",
    .equations = "EW18 11, 12, 13, A.5",
    .function = "whole_drag_drag",
    .keys = {keys},
    .create = whole_drag_create,
    .before_particles = whole_drag_before_particles,
    .drag = whole_drag_drag,
    .estimate = whole_drag_estimate,
    .cost = {10.0, 0.0, 0.0},
};
