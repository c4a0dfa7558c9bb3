/* SPDX-License-Identifier: GPL-3.0-or-later */
/* whole_drag.c -- the force of the averaged stress: as an effect of its own, or
 * as a part of a drag that is the whole force. */
#include "base/alloc.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "fluid/deferred.h"

#include <gsl/gsl_math.h>
#include <stddef.h>

/* --- viscous stress ------------------------------------------------------- */

/* The viscous part of the force of an undisturbed flow,
 *
 *   f_i = V_p div tau,   div tau = mu lap u       [LS 5.1, XS11 2.6, second
 * term]
 *
 * the force of the surrounding stress on the fluid that would be in its place.
 * The fluid's equation contains all of div tau, so the reaction of the force on
 * a particle acts on the fluid in its next step. This is stable for any step:
 * the part of the fluid is implicit, and that of the particles is smaller.
 *
 * lap u of a cell from its faces as in momentum.c, (1/V) sum (S/d) (u_N - u);
 * at a boundary u_N is the velocity there, which on a slip wall and an outlet
 * has the tangential part of u. Where links are oblique to their faces the rest
 * of S is added as there (deferred_correction.c), from the slopes of u. */

struct viscous_stress {
    double *force; /* [N/m^3] div tau, 3 a cell */
    double *u_b;   /* [m/s] at the boundary, 3 a face */
    double *slope; /* [1/s] of u, 9 a cell; NULL where no link is oblique */
    double *at;    /* [N/m^3] interpolated to the particles, 3 each */
};

static void *viscous_stress_create(struct simulation *sim,
                                   const double *parameters)
{
    const struct mesh *const m = sim->mesh;
    struct viscous_stress *const self = owner_create(sizeof *self);

    (void)parameters;
    self->force = owner_doubles(self, 3 * m->n_cells);
    self->u_b = owner_doubles(self, 3 * (m->n_faces - m->n_internal));
    if (m->oblique) self->slope = owner_doubles(self, 9 * m->n_cells);
    self->at = owner_doubles(self, 3 * sim->particles->capacity);
    return self;
}

/* Area over length of a link [m]. */
static double link(const struct mesh *m, int f)
{
    const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);

    return vector_dot(S, S) / vector_dot(S, d);
}

/* Adds mu grad u . (S - d S.S / S.d), linear between the cells. */
static void add_oblique(struct viscous_stress *self, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    boundary_reach_gradient(fl, fl->u, self->u_b, self->slope);
    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        double rest[3];
        mesh_oblique_part(m, f, rest);
        for (int k = 0; k < 3; k++) {
            const double pull =
                fl->options.mu *
                (m->w[f] * vector_dot(&self->slope[9 * o + 3 * k], rest) +
                 (1.0 - m->w[f]) *
                     vector_dot(&self->slope[9 * n + 3 * k], rest)); /* [N] */
            self->force[3 * o + k] += pull / m->V[o];
            self->force[3 * n + k] -= pull / m->V[n];
        }
    }
}

/* div tau [N/m^3] of all cells. */
static void divergence(struct viscous_stress *self, const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double *const force = self->force;

    for (int i = 0; i < 3 * m->n_cells; i++)
        force[i] = 0.0;
    fluid_boundary_velocity(fl, self->u_b);
    for (int f = 0; f < m->n_faces; f++) {
        const int o = m->owner[f], inner = f < m->n_internal;
        const int n = inner ? m->neighbour[f] : o;
        const double *const u_N =
            inner ? &fl->u[3 * n] : &self->u_b[3 * (f - m->n_internal)];
        const double D = fl->options.mu * link(m, f);
        for (int k = 0; k < 3; k++) {
            const double pull = D * (u_N[k] - fl->u[3 * o + k]); /* [N] */
            force[3 * o + k] += pull / m->V[o];
            if (inner) force[3 * n + k] -= pull / m->V[n];
        }
    }
    if (self->slope != NULL) add_oblique(self, fl);
}

static void viscous_stress_before_particles(void *memory,
                                            struct simulation *sim)
{
    struct viscous_stress *const self = memory;
    const struct particles *const ps = sim->particles;

    divergence(self, sim->fluid);
    averaging_gather(sim->averaging, 3, self->force, self->at);
    averaging_apply_cap(sim->averaging, 3, self->at);
    for (int i = 0; i < ps->n; i++) {
        const double V = particles_volume(ps, i);
        double f[3], impulse[3];
        for (int k = 0; k < 3; k++) {
            f[k] = V * self->at[3 * i + k]; /* [LS 5.1, XS11 2.6] */
            sim->held_force[3 * i + k] += f[k];
            impulse[k] = f[k] * sim->dt;
        }
        effects_report(sim, f, 1.0);
        coupling_add_impulse(sim, i, impulse);
    }
}

/* V mu lap u, of a velocity that changes by the slip over the length; the
 * stress of a flow that is driven between walls, at twice the length, comes to
 * balance the push within T. */
static struct effect_estimate
viscous_stress_estimate(const struct effect_scales *k)
{
    const double V = M_PI / 6.0 * k->d * k->d * k->d;
    const double x = /* end over T */
        k->mu * k->end / (4.0 * k->rho_f * gsl_pow_2(k->length / M_PI));
    const double grown = x > 0.0 ? 1.0 + expm1(-x) / x : 0.0;

    return effects_estimate(V *
                                (k->mu * k->slip / gsl_pow_2(k->length) +
                                 grown * k->mean_gradient) /
                                k->force,
                            "");
}

static const struct key viscous_stress_keys[] = {
    {"effects.viscous_stress", KEY_GROUP, "", "", KEY_OPTIONAL,
     "force of the viscous stress of the undisturbed flow on the particles",
     "LS 5.1, XS11 2.6", "fluid particles averaging exchange"},
    KEY_END};

const struct effect viscous_stress_effect = {
    .name = "viscous_stress",
    .what = "force of the viscous stress of the undisturbed flow",
    .equations = "LS 5.1, XS11 2.6",
    .function = "viscous_stress_before_particles",
    .keys = {viscous_stress_keys},
    .create = viscous_stress_create,
    .before_particles = viscous_stress_before_particles,
    .estimate = viscous_stress_estimate,
    .cost = {17.0, 64.0, 0.0},
};

/* --- whole drag ----------------------------------------------------------- */

/* The drag law gives the whole force of the flow on a particle,
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
 * eps_s, and gets the buoyancy back for these only (averaging_apply_cap). */

static void whole_drag_drag(void *memory, struct simulation *sim, double *k)
{
    const double *const eps = sim->coupling->eps;

    (void)memory;
    for (int i = 0; i < sim->particles->n; i++)
        k[i] /= eps[i]; /* [SX15 3, EW18 11, A.5] */
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

    return effects_estimate(
        (k->drag * k->passed / (1.0 - k->passed) + V * k->rho_f * k->gravity) /
            k->force,
        "");
}

static const struct key whole_drag_keys[] = {
    {"effects.whole_drag", KEY_GROUP, "", "", KEY_OPTIONAL,
     "the drag law divided by eps_f, and buoyancy, in place of the pressure "
     "gradient",
     "EW18 11-13, A.5",
     "fluid particles averaging exchange !effects.pressure_gradient"},
    KEY_END};

const struct effect whole_drag_effect = {
    .name = "whole_drag",
    .what = "the drag law as the whole force, without a pressure gradient",
    .equations = "SX15 2b, SX15 3, EW18 11, 12, 13, A.5",
    .function = "whole_drag_drag",
    .keys = {whole_drag_keys},
    .before_particles = whole_drag_before_particles,
    .drag = whole_drag_drag,
    .estimate = whole_drag_estimate,
    .cost = {10.0, 0.0, 0.0},
};
