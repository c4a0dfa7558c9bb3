/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/forces.h"

#include "base/alloc.h"
#include "coupling/effects.h"
#include "coupling/simulation.h"
#include "coupling/transfer.h"

double time_average_weight(double dt, double b_t)
{
    return 1.0 / (1.0 + dt / b_t);
}

/* An implicit step [SX15 13] of the mean in which a value of age t weighs
 * exp(-t / b_t) / b_t [SX15 11]. */
void time_average_update(double alpha, int n, const double *now, double *mean)
{
    for (int i = 0; i < n; i++)
        mean[i] = (1.0 - alpha) * now[i] + alpha * mean[i];
}

static void *time_average_create(struct simulation *sim,
                                 const double *parameters)
{
    struct time_average *const self = owner_create(sizeof *self);
    const int n = sim->mesh->n_cells;

    self->alpha = time_average_weight(sim->dt, parameters[0]);
    self->n = n;
    self->eps = owner_doubles(self, n);
    self->eps_us = owner_doubles(self, 3 * n);
    return self;
}

/* The mean starts from the first field, not from zero. */
static void time_average_after_step(void *memory, struct simulation *sim)
{
    struct time_average *const self = memory;
    const struct fluid *const fl = sim->fluid;
    const int n = sim->mesh->n_cells;
    const double alpha = sim->steps == 1 ? 0.0 : self->alpha;

    transfer_solids_velocity(sim);
    time_average_update(alpha, n, fl->eps, self->eps);
    time_average_update(alpha, 3 * n, fl->eps_us, self->eps_us);
}

static void time_average_state(void *memory, struct state *s)
{
    struct time_average *const self = memory;

    state_reals(s, "eps", "-", self->eps, self->n, 1);
    state_reals(s, "eps_us", "m/s", self->eps_us, self->n, 3);
}

static int time_average_fields(const void *memory, struct effect_field *f)
{
    const struct time_average *const self = memory;

    f[0] = (struct effect_field){"mean_void_fraction", 1, self->eps};
    f[1] = (struct effect_field){"mean_solid_flux", 3, self->eps_us};
    return 2;
}

static const struct key time_average_keys[] = {
    {"effects.time_average", KEY_GROUP, "", "", KEY_OPTIONAL,
     "exponential moving averages of eps_f and eps_s u_s, written with the "
     "fluid",
     "SX15 11-14", "fluid particles averaging exchange",
     KEY_GIVEN(effects_options, time_average)},
    {"effects.time_average.time", KEY_REAL, "s", "> 0", NULL,
     "bandwidth b_t of the average in time", "SX15 11", ""},
    KEY_END};

const struct effect time_average_effect = {
    .name = "time_average",
    .what = "exponential moving averages of the averaged fields",
    .equations = "SX15 11-14",
    .function = "time_average_update",
    .keys = {time_average_keys},
    .create = time_average_create,
    .after_step = time_average_after_step,
    .fields = time_average_fields,
    .state = time_average_state,
};
