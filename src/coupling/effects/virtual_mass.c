/* SPDX-License-Identifier: GPL-3.0-or-later */
/* virtual_mass.c -- the added mass of fluid that accelerates with a particle,
 *
 *   f_i = C rho_f V_p (Du/Dt - dv/dt),   Du/Dt = du/dt + u . grad u  [LS 5.3]
 *
 * C = 1/2 for a sphere. The second part is an added mass in every
 * particle step (implicit_drag.h), the first a force that is constant in a
 * step. The reaction to the impulse of the step, C rho_f V_p (Du/Dt dt - change
 * of v), acts on the fluid in its next step, but for what is charged in advance
 * (effect_force.h): a share of the term C rho_f V_p du/dt acts in the step
 * itself. Were all of it left to the next step, each change of the fluid's
 * velocity would be followed there by one of -C eps_s/eps_f times itself, which
 * is large in a packed bed; were all of it charged in advance, a bed in a
 * liquid would be unstable (transfer.h).
 *
 * Du/Dt from the last two fields: du/dt their difference, and u . grad u from
 * the fluxes, (1/(eps V)) sum phi (u_f - u_c); through a boundary u_f = u_c.
 * In the first step there is no earlier field, and Du/Dt is 0.
 */
#include "coupling/effect.h"
#include "coupling/effects.h"

#include <gsl/gsl_math.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/coupling.h"

struct virtual_mass {
    double C; /* [-] */
    int n_cells;
    double *past;  /* [m/s] u of the step before, 3 a cell */
    double *Du;    /* [m/s^2] Du/Dt, 3 a cell */
    double *at;    /* [m/s^2] interpolated to the particles, 3 each */
    double *start; /* [m/s] their velocity at the start of the step, 3 each */
    double *mass;  /* [kg] the added mass of each */
};

static void *virtual_mass_create(struct simulation *sim,
                                 const double *parameters)
{
    struct virtual_mass *const self = owner_create(sizeof *self);
    struct particles *const ps = sim->particles;
    const int cells = sim->mesh->n_cells;

    particles_add_implicit_drag(ps);
    effect_force_inertia(sim);
    self->C = parameters[0];
    self->n_cells = cells;
    self->past = owner_doubles(self, 3 * cells);
    self->Du = owner_doubles(self, 3 * cells);
    self->at = particles_new_array(ps, "Du_Dt", "m/s^2", 3);
    self->start = particles_new_array(ps, "v_start", "m/s", 3);
    self->mass = particles_new_array(ps, "virtual_mass", "kg", 1);
    return self;
}

/* u . grad u of all cells, added to Du. */
static void add_convection(const struct fluid *fl, double *Du)
{
    const struct mesh *const m = fl->mesh;

    for (int f = 0; f < m->n_internal; f++) {
        const int o = m->owner[f], n = m->neighbour[f];
        const double w = m->w[f], phi = fl->phi[f];
        for (int k = 0; k < 3; k++) {
            const double jump = fl->u[3 * n + k] - fl->u[3 * o + k];
            /* u_f = w u_o + (1 - w) u_n */
            Du[3 * o + k] += phi * (1.0 - w) * jump / (fl->eps[o] * m->V[o]);
            Du[3 * n + k] += phi * w * jump / (fl->eps[n] * m->V[n]);
        }
    }
}

/* Du/Dt [m/s^2] from u now and in the step before. */
static void material_derivative(struct virtual_mass *self,
                                const struct simulation *sim)
{
    const struct fluid *const fl = sim->fluid;
    const int n = 3 * sim->mesh->n_cells;
    const double per_dt = sim->steps > 0 ? 1.0 / sim->dt : 0.0;

    for (int i = 0; i < n; i++)
        self->Du[i] = per_dt * (fl->u[i] - self->past[i]);
    if (sim->steps > 0) add_convection(fl, self->Du);
    memcpy(self->past, fl->u, (size_t)n * sizeof *self->past);
}

/* [LS 5.3]: its first part as a force, its second as a mass. */
static void virtual_mass_before_particles(void *memory, struct simulation *sim)
{
    struct virtual_mass *const self = memory;
    struct particles *const ps = sim->particles;
    const double rho = sim->fluid->options.rho;

    material_derivative(self, sim);
    averaging_gather(sim->averaging, 3, self->Du, self->at);
    for (int i = 0; i < ps->n; i++)
        self->mass[i] = self->C * rho * particles_volume(ps, i);
    averaging_apply_cap(sim->averaging, 1, self->mass);
    for (int i = 0; i < ps->n; i++) {
        ps->added_mass[i] += self->mass[i];
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        for (int k = 0; k < 3; k++) {
            self->start[3 * i + k] = v[k];
            sim->held_force[3 * i + k] += self->mass[i] * self->at[3 * i + k];
        }
    }
}

/* The impulse of the step, and the inertia of the next one. */
static void virtual_mass_after_particles(void *memory, struct simulation *sim)
{
    const struct virtual_mass *const self = memory;
    const struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        double impulse[3], f[3];
        for (int k = 0; k < 3; k++) {
            impulse[k] = self->mass[i] * (self->at[3 * i + k] * sim->dt - v[k] +
                                          self->start[3 * i + k]);
            f[k] = impulse[k] / sim->dt;
        }
        effect_force_charge(sim, i, self->mass[i]);
        coupling_add_impulse(sim, i, impulse);
        effects_report(sim, f, 1.0);
    }
}

static void virtual_mass_state(void *memory, struct state *s)
{
    struct virtual_mass *const self = memory;

    state_reals(s, "u_past", "m/s", self->past, self->n_cells, 3);
}

/* A slip that is driven begins with a start, in which the fluid that goes along
 * takes its part of the push for as long as the slip grows. What the fluid of a
 * jet loses of its speed acts on the share of the grains that is in it. */
static struct effect_estimate
virtual_mass_estimate(const struct effect_scales *k)
{
    const double C = k->numbers != NULL ? k->numbers[0] : 0.5;
    const double V = M_PI / 6.0 * k->d * k->d * k->d;

    const double ratio = C * k->rho_f / k->rho_s, part = ratio / (1.0 + ratio);
    const double each = C * k->rho_f * V / k->force;
    struct effect_estimate e = effects_estimate(
        each * (k->acceleration + k->fluctuation + k->slows), "");

    if (k->slows > 0.0) {
        e.loss += each * k->slows * (1.0 / k->jet - 1.0);
        e.of = "the force on a grain in the jet";
    }
    if (part > 0.05 && k->tau > 0.0 && !k->decays)
        snprintf(e.remark, sizeof e.remark,
                 "%.2g %% of the push in the first %.2g s", 100.0 * part,
                 k->tau * (1.0 + ratio));
    return e;
}

static void virtual_mass_added_mass(const struct effect_scales *k,
                                    struct added_mass *sum)
{
    sum->C += k->numbers[0];
}

static const struct key keys[] = {
    {"effects.virtual_mass", KEY_GROUP, "", "", KEY_OPTIONAL,
     "inertia of the fluid that is accelerated with a particle", "LS 5.3",
     "fluid particles averaging exchange",
     .divided = "it acts within the integrator, which is LAMMPS'"},
    {"effects.virtual_mass.coefficient", KEY_REAL, "-", ">= 0", "0.5",
     "C; 1/2 for a sphere", "LS 5.3", ""},
    KEY_END};

const struct effect virtual_mass_effect = {
    .name = "virtual_mass",
    .what = "inertia of the fluid that is accelerated with a particle",
    .equations = "LS 5.3",
    .function = "virtual_mass_before_particles",
    .keys = {keys},
    .create = virtual_mass_create,
    .before_particles = virtual_mass_before_particles,
    .after_particles = virtual_mass_after_particles,
    .state = virtual_mass_state,
    .estimate = virtual_mass_estimate,
    .added_mass = virtual_mass_added_mass,
    .cost = {23.0, 37.0, 11.0},
};
