/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects.h"

#include "base/alloc.h"
#include "base/clock.h"
#include "base/model.h"
#include "base/parallel_ranges.h"
#include "base/vector.h"
#include "coupling/coupling.h"
#include "coupling/transfer.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void effects_add(struct simulation *sim, const struct effect *e, void *memory)
{
    sim->effects = alloc_grown(sim->effects, sim->n_effects, sim->n_effects + 1,
                               sizeof *sim->effects);
    sim->effects[sim->n_effects++] =
        (struct effect_state){.effect = e, .memory = memory};
}

void effects_create(struct simulation *sim, const struct effect *e,
                    const double *parameters)
{
    effects_add(sim, e, NULL);
    sim->running_effect = &sim->effects[sim->n_effects - 1];
    if (e->create != NULL)
        sim->running_effect->memory = e->create(sim, parameters);
    sim->running_effect = NULL;
}

void *effects_memory(const struct simulation *sim, const struct effect *e)
{
    for (int i = 0; i < sim->n_effects; i++)
        if (sim->effects[i].effect == e) return sim->effects[i].memory;
    return NULL;
}

void effects_free(struct simulation *sim)
{
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        (e->effect->free != NULL ? e->effect->free : owner_free)(e->memory);
    }
    free(sim->effects);
}

/* Each adds its part to the sum of the forces [LS 5.8, EW18 12]. */
void effects_call(struct simulation *sim, enum effects_stage stage)
{
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect *const e = sim->effects[i].effect;
        void (*const hook[])(void *, struct simulation *) = {
            e->before_particles, e->before_substep, e->after_particles,
            e->after_step};
        if (hook[stage] == NULL) continue;
        double clock = clock_now();
        sim->running_effect = &sim->effects[i];
        hook[stage](sim->running_effect->memory, sim);
        clock_add(&sim->running_effect->tally.seconds, &clock);
    }
}

void effects_tally_add(struct effect_tally *t, double size, double share)
{
    t->sum += share * size;
    t->weight += share;
    t->largest = size > t->largest ? size : t->largest;
}

void effects_report(struct simulation *sim, const double f[3], double share)
{
    if (sim->running_effect != NULL)
        effects_tally_add(&sim->running_effect->tally, vector_length(f), share);
}

static void tally_range(int first, int last, struct simulation *sim,
                        effects_range *f, const void *memory,
                        struct effect_tally *parts)
{
    f(first, last, sim, memory,
      &parts[parallel_ranges_of(sim->particles->n, first)]);
}

/* Adds what f tells of all particles to t. */
static void tally_all(struct simulation *sim, struct effect_tally *t,
                      effects_range *f, const void *memory)
{
    struct effect_tally parts[PARALLEL_RANGES_COUNT] = {{0}};
    const int n = sim->particles->n;

    PARALLEL_RANGES(n, 12, tally_range, sim, f, memory, parts);
    for (int s = 0; s < parallel_ranges_filled(n); s++) {
        t->sum += parts[s].sum;
        t->weight += parts[s].weight;
        t->largest = fmax(t->largest, parts[s].largest);
    }
}

void effects_report_all(struct simulation *sim, effects_range *f,
                        const void *memory)
{
    struct effect_tally none = {0};

    tally_all(sim,
              sim->running_effect != NULL ? &sim->running_effect->tally : &none,
              f, memory);
}

/* The drag on each, or its weight, or the force that drives the fluid. */
static void scale_range(int first, int last, struct simulation *sim,
                        const void *push, struct effect_tally *tally)
{
    const double size = vector_length(sim->gravity);

    for (int i = first; i < last; i++) {
        const double drag = sim->coupling != NULL ? transfer_drag(sim, i) : 0.0;
        const double V = M_PI / 6.0 * gsl_pow_3(sim->particles->d[i]);
        const double weight = sim->particles->m[i] * size;
        const double pushed = V * *(const double *)push;
        const double held = weight > pushed ? weight : pushed;
        effects_tally_add(tally, drag > held ? drag : held, 1.0);
    }
}

void effects_measure_scale(struct simulation *sim)
{
    const double push = sim->fluid != NULL
                            ? vector_length(sim->fluid->options.mean_gradient)
                            : 0.0;

    if (sim->n_effects > 0)
        tally_all(sim, &sim->force_scale, scale_range, &push);
}

static const char of_force[] = "the force on a grain";

struct effect_estimate effects_estimate(double share, const char *remark)
{
    struct effect_estimate e = {.share = share, .loss = share, .of = of_force};

    snprintf(e.remark, sizeof e.remark, "%s", remark);
    return e;
}

struct effect_estimate effects_unknown(double most, const char *format, ...)
{
    struct effect_estimate e = {
        .share = most, .loss = most, .of = of_force, .unknown = 1};
    va_list args;

    va_start(args, format);
    vsnprintf(e.remark, sizeof e.remark, format, args);
    va_end(args);
    return e;
}

const struct key effects_keys[] = {
    {"effects", KEY_GROUP, "", "", "",
     "further effects; each is on only where it is named", "", "",
     .divided = KEY_DIVIDED},
    KEY_END};

const struct effect *const effects[] = {&gravity_effect,
                                        &pressure_gradient_effect,
                                        &viscous_stress_effect,
                                        &virtual_mass_effect,
                                        &basset_effect,
                                        &saffman_effect,
                                        &fluid_torque_effect,
                                        &magnus_effect,
                                        &time_average_effect,
                                        &energy_budget_effect,
                                        &cohesion_electrostatic,
                                        &cohesion_van_der_waals,
                                        &cohesion_capillary,
                                        &whole_drag_effect,
                                        &stochastic_drag_effect,
                                        &lubrication_effect,
                                        &bubbles_effect,
                                        &mixing_effect,
                                        &particle_stress_effect,
                                        &collision_damping_effect,
                                        &collision_isotropy_effect,
                                        NULL};

/* --- effect force --------------------------------------------------------- */

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
    cp->inertia = particles_new_array(sim->particles, "inertia", "kg", 1);
    cp->u_before = particles_new_array(sim->particles, "u_before", "m/s", 3);
}

/* Charges the fluid in advance for an added mass m [kg] of particle i. */
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

MODEL_NAMED(effect)
