/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/alloc.h"
#include "base/clock.h"
#include "base/number.h"
#include "coupling/coupling.h"
#include "coupling/effect.h"
#include "coupling/effects.h"
#include "coupling/processes.h"
#include "coupling/replacement.h"
#include "coupling/simulation.h"
#include "coupling/transfer.h"
#include "dem/population/population.h"

#include <math.h>
#include <string.h>

struct coupling *coupling_create(struct simulation *sim,
                                 const struct coupling_options *options)
{
    struct particles *const ps = sim->particles;
    const int n = ps->capacity, cells = sim->mesh->n_cells;
    struct coupling *const cp = owner_create(sizeof *cp);

    cp->options = *options;
    cp->law = *options->law;
    cp->options.law = &cp->law;
    cp->report.eps_lowest = cp->report.lowest_interpolated =
        1.0; /* unchanged in one-way coupling */
    cp->u_f = particles_new_array(ps, "u_f", "m/s", 3);
    cp->eps = particles_new_array(ps, "eps", "-", 1);
    cp->k = particles_new_array(ps, "k", "kg/s", 1);
    cp->rate = particles_new_array(ps, "rate", "kg/s", 1);
    cp->u_mean = particles_new_array(ps, "u_mean", "m/s", 3);
    cp->unpaid_impulse = particles_new_array(ps, "unpaid_impulse", "N s", 3);
    cp->smooth = owner_doubles(cp, 3 * n);
    cp->amount = owner_doubles(cp, 4 * n);
    cp->field = owner_doubles(cp, 4 * cells);
    if (options->interpolation == interpolation_named("linear"))
        cp->u_b =
            owner_doubles(cp, 3 * (sim->mesh->n_faces - sim->mesh->n_internal));
    if (options->slip_integration == SLIP_INTEGRATION_EXPONENTIAL)
        particles_add_implicit_drag(ps);
    return cp;
}

int coupling_start(struct simulation *sim)
{
    processes_join(sim, PROCESSES_START);
    if (sim->coupling == NULL) return 0;
    transfer_start_velocity(sim, 0);
    if (processes_largest(sim, transfer_average(sim)) != 0) return 1;
    fluid_reset_eps_history(sim->fluid);
    transfer_fluid(sim); /* u_f, for the slip in the first k */
    transfer_drag_terms(sim);
    return 0;
}

/* Sets the forces of effects that are constant during this step. */
static void set_held_forces(struct simulation *sim)
{
    struct particles *const ps = sim->particles;
    const size_t n = (size_t)ps->n;

    memset(sim->held_force, 0, 3 * n * sizeof *sim->held_force);
    if (ps->added_mass != NULL)
        memset(ps->added_mass, 0, n * sizeof *ps->added_mass);
    effects_call(sim, EFFECTS_BEFORE_PARTICLES);
}

/* Sets the external force [N] on each particle to the constant forces of the
 * effects. */
static void apply_held_forces(struct simulation *sim)
{
    struct particles *const ps = sim->particles;

#pragma omp parallel for schedule(static) if (ps->n >= TRANSFER_MANY)
    for (int i = 0; i < ps->n; i++) {
        ps->ex[i] = sim->held_force[3 * i];
        ps->ey[i] = sim->held_force[3 * i + 1];
        ps->ez[i] = sim->held_force[3 * i + 2];
    }
}

double coupling_needed_substeps(double x)
{
    return x > 0.5 ? fmax(2.0, ceil(x)) : 1.0;
}

/* Number of drag updates in this step: at most the number of particle steps. */
static int count_substeps(const struct simulation *sim)
{
    const struct coupling *const cp = sim->coupling;
    double n = cp->options.substeps;

    if (n == 0.0)
        n = coupling_needed_substeps(sim->dt / cp->report.shortest_time);
    return number_clamped(n, 1, sim->dem_steps);
}

/* The report of a step in several parts has the sum of their rebuilds and the
 * deepest of their overlaps. */
static void add_before(struct dem_report *r, const struct dem_report *before)
{
    r->steps += before->steps;
    r->rebuilds += before->rebuilds;
    r->max_overlap = fmax(r->max_overlap, before->max_overlap);
}

/* Moves the particles, or the effect that moves them together with bodies. */
static int run_particles(struct simulation *sim, int steps)
{
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        if (e->effect->mover != NULL &&
            e->effect->mover->move_particles != NULL)
            return e->effect->mover->move_particles(e->memory, sim, steps);
    }
    return dem_run(sim->dem, steps, &sim->dem_report);
}

/* Steps 3 and 4: moves the particles through the sub-steps, each with the drag
 * at its start. */
static int move_with_drag(struct simulation *sim, double *clock)
{
    struct coupling_report *const report = &sim->coupling->report;
    const int n = report->substeps = count_substeps(sim);
    struct dem_report before = {0};
    int failed = 0;

    transfer_begin_substeps(sim);
    for (int k = 0; k < n && !failed; k++) {
        const long all = sim->dem_steps; /* in n equal parts, rounded down */
        const int steps = (int)(all * (k + 1) / n - all * k / n);
        apply_held_forces(sim);
        sim->substep = sim->dt * steps / sim->dem_steps;
        effects_call(sim, EFFECTS_BEFORE_SUBSTEP);
        transfer_begin_substep(sim, steps);
        clock_add(&sim->seconds.exchange, clock);
        failed = run_particles(sim, steps);
        clock_add(&sim->seconds.dem, clock);
        add_before(&sim->dem_report, &before);
        before = sim->dem_report;
        transfer_end_substep(sim, steps);
    }
    return failed;
}

/* Moves the particles for a step of the fluid without sub-steps of the drag. */
static int move_freely(struct simulation *sim, double *clock)
{
    apply_held_forces(sim);
    clock_add(&sim->seconds.exchange, clock);
    const int failed = run_particles(sim, sim->dem_steps);
    clock_add(&sim->seconds.dem, clock);
    return failed;
}

/* Moves what is neither fluid nor particle, such as bodies in the flow; ends if
 * an effect has failed. */
static int move_others(struct simulation *sim)
{
    int failed = 0;

    for (int i = 0; i < sim->n_effects && !failed; i++) {
        const struct effect_state *const e = &sim->effects[i];
        if (e->effect->mover != NULL && e->effect->mover->move != NULL)
            failed = e->effect->mover->move(e->memory, sim);
        if (e->effect->failure != NULL)
            failed |= e->effect->failure(e->memory) != NULL;
    }
    return failed;
}

/* [XS11 Algorithm 3.1]; the numbers are those of its steps. */
int coupling_step(struct simulation *sim)
{
    double clock = clock_now();
    int failed = 0;

    processes_join(sim, PROCESSES_STEP);
    if (sim->population != NULL) failed = replacement_step(sim);

    /* 1. The fluid moves from u^(n-1), p^(n-1) to u^n, p^n. */
    if (sim->fluid != NULL && !failed)
        failed = fluid_advance(sim->fluid, sim->dt);
    clock_add(&sim->seconds.cfd, &clock);

    if (sim->particles != NULL && !failed) {
        /* 2. Interpolate the new fluid velocity; subtract what the fluid
         * received. */
        if (sim->coupling != NULL) transfer_fluid(sim);
        set_held_forces(sim);
        clock_add(&sim->seconds.exchange, &clock);

        /* 3, 4. Drag and collisions, sub-step by sub-step. */
        failed = sim->coupling != NULL ? move_with_drag(sim, &clock)
                                       : move_freely(sim, &clock);
        if (!failed) effects_call(sim, EFFECTS_AFTER_PARTICLES);

        /* 5. New eps_s and u_s; from them Omega and A for the next step. */
        if (sim->coupling != NULL && !failed) {
            failed = transfer_average(sim);
            clock_add(&sim->seconds.averaging, &clock);
            if (!failed) transfer_drag_terms(sim);
        }
        if (!failed) effects_measure_scale(sim);
    }
    if (!failed) failed = move_others(sim);
    if (!failed) {
        sim->steps++;
        sim->t = (double)sim->steps * sim->dt;
        effects_call(sim, EFFECTS_AFTER_STEP);
    }
    clock_add(&sim->seconds.exchange, &clock);
    return processes_largest(sim, failed);
}

/* The arrays of the particles are attached to them and visited there; the
 * unpaid impulse of removed particles acts within the step that removes them.
 * The field of the last step is needed for the check in the next one. */
void coupling_state(struct simulation *sim, struct state *s)
{
    if (sim->population != NULL) population_state(sim->population, s);
    if (sim->coupling == NULL) return;
    struct coupling_report *const r = &sim->coupling->report;
    state_begin(s, "coupling");
    state_reals(s, "K_and_F", "kg/(m^3 s) N/m^3", sim->coupling->field,
                sim->mesh->n_cells, 4);
    state_whole(s, "substeps", "-", &r->substeps);
    state_real(s, "shortest_time", "s", &r->shortest_time);
    state_real(s, "exchange_residual", "-", &r->exchange_residual);
    state_real(s, "eps_lowest", "-", &r->eps_lowest);
    state_real(s, "lowest_interpolated", "-", &r->lowest_interpolated);
    state_end(s);
}

void coupling_add_impulse(struct simulation *sim, int i,
                          const double impulse[3])
{
    struct coupling *const cp = sim->coupling;

    for (int k = 0; k < 3 && cp->options.two_way; k++)
        cp->unpaid_impulse[3 * i + k] += impulse[k];
}

void coupling_slip(const struct simulation *sim, int i, double w[3])
{
    const struct particles *const ps = sim->particles;
    const double *const u = &sim->coupling->u_f[3 * i];

    w[0] = u[0] - ps->vx[i];
    w[1] = u[1] - ps->vy[i];
    w[2] = u[2] - ps->vz[i];
}

void coupling_unpaid_impulse(const struct simulation *sim, double unpaid[3])
{
    unpaid[0] = unpaid[1] = unpaid[2] = 0.0;
    if (sim->coupling == NULL) return;
    for (int i = 0; i < sim->particles->n; i++)
        for (int k = 0; k < 3; k++)
            unpaid[k] += sim->coupling->unpaid_impulse[3 * i + k];
    for (int k = 0; k < 3 && sim->coupling->replacement != NULL; k++)
        unpaid[k] += sim->coupling->replacement->unpaid_sum[k];
    processes_sum(sim, 3, unpaid);
}

void coupling_total_momentum(const struct simulation *sim, double total[3])
{
    const struct particles *const ps = sim->particles;
    double unpaid[3];

    total[0] = total[1] = total[2] = 0.0;
    if (sim->fluid != NULL) fluid_momentum(sim->fluid, total);
    for (int i = 0; ps != NULL && i < ps->n; i++) {
        total[0] += ps->m[i] * ps->vx[i];
        total[1] += ps->m[i] * ps->vy[i];
        total[2] += ps->m[i] * ps->vz[i];
    }
    processes_sum(sim, 3, total);
    coupling_unpaid_impulse(sim, unpaid);
    for (int k = 0; k < 3; k++)
        total[k] -= unpaid[k];
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect_state *const e = &sim->effects[i];
        if (e->effect->mover != NULL)
            e->effect->mover->momentum(e->memory, total);
    }
}

/* --- simulation state ----------------------------------------------------- */

/* The visit of all parts.  Chapter "Nothing is lost". */

static void seconds_state(struct seconds *spent, struct state *s)
{
    double *const all[] = {&spent->cfd,      &spent->dem,    &spent->averaging,
                           &spent->exchange, &spent->output, &spent->processor};

    state_several(s, "seconds", "s", all, sizeof all / sizeof *all);
}

static void tally_state(struct effect_tally *t, struct state *s)
{
    state_real(s, "sum", "N", &t->sum);
    state_real(s, "largest", "N", &t->largest);
    state_real(s, "seconds", "s", &t->seconds);
    state_real(s, "weight", "-", &t->weight);
}

static void effects_state(struct simulation *sim, struct state *s)
{
    state_begin(s, "effects");
    tally_state(&sim->force_scale, s);
    for (int i = 0; i < sim->n_effects; i++) {
        const struct effect *const e = sim->effects[i].effect;
        state_begin(s, e->name);
        tally_state(&sim->effects[i].tally, s);
        if (e->state != NULL) e->state(sim->effects[i].memory, s);
        state_end(s);
    }
    state_end(s);
}

/* The particles are visited first: their number gives that of other rows. The
 * state of the averaging follows from theirs. */
int simulation_state(struct simulation *sim, struct state *s)
{
    state_real(s, "t", "s", &sim->t);
    state_long(s, "steps", "-", &sim->steps);
    state_demand(s,
                 sim->steps >= 0 && fabs(sim->t - (double)sim->steps *
                                                      sim->dt) <= 0.5 * sim->dt,
                 "a number of steps that is not that of its time");
    seconds_state(&sim->seconds, s);
    if (sim->processes != NULL) {
        sim->processes->state(sim->processes, s);
    } else {
        if (sim->particles != NULL) particles_state(sim->particles, s);
        if (sim->dem != NULL) dem_state(sim->dem, s);
        if (sim->fluid != NULL) fluid_state(sim->fluid, s);
        coupling_state(sim, s);
    }
    effects_state(sim, s);
    if (s->loading && !s->failed && sim->averaging != NULL)
        s->failed = averaging_bind(sim->averaging) != 0;
    return s->failed;
}
