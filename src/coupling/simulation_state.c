/* SPDX-License-Identifier: GPL-3.0-or-later */
/* simulation_state.c -- the visit of all parts.  Chapter "Nothing is lost". */
#include <math.h>

#include "coupling/simulation.h"

#include "coupling/coupling.h"
#include "coupling/processes.h"

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

/* The particles are visited first: their number gives that of other rows. */
static void visit_fields(struct simulation *sim, struct state *s)
{
    if (sim->particles != NULL) particles_state(sim->particles, s);
    if (sim->dem != NULL) dem_state(sim->dem, s);
    if (sim->fluid != NULL) fluid_state(sim->fluid, s);
    coupling_state(sim, s);
}

/* The state of the averaging follows from that of the particles. */
int simulation_state(struct simulation *sim, struct state *s)
{
    state_real(s, "t", "s", &sim->t);
    state_long(s, "steps", "-", &sim->steps);
    state_demand(s,
                 sim->steps >= 0 && fabs(sim->t - (double)sim->steps *
                                                      sim->dt) <= 0.5 * sim->dt,
                 "a number of steps that is not that of its time");
    seconds_state(&sim->seconds, s);
    if (sim->processes != NULL)
        sim->processes->state(sim->processes, s);
    else
        visit_fields(sim, s);
    effects_state(sim, s);
    if (s->loading && !s->failed && sim->averaging != NULL)
        s->failed = averaging_bind(sim->averaging) != 0;
    return s->failed;
}
