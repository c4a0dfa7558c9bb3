/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/bodies_effect.h"

#include "coupling/effect_mover.h"
#include "coupling/simulation.h"
#include "resolved/among_grains.h"
#include "resolved/body_motion.h"

static int bodies_effect_move(void *memory, struct simulation *sim)
{
    struct solid_bodies *const b = memory;
    return b->among == NULL ? body_motion_advance(b, sim->dt) : 0;
}

static const char *bodies_effect_trouble(const void *memory)
{
    const struct solid_bodies *const b = memory;
    return b->dem_report.lost > 0
               ? "a body left the box, or its velocity is no longer finite; "
                 "try "
                 "a smaller fluid.step or a higher bodies.stiffness:"
               : NULL;
}

static void bodies_effect_momentum(const void *memory, double total[3])
{
    const struct solid_bodies *const b = memory;
    body_motion_add_momentum(b, total);
    if (b->among != NULL) among_grains_add_momentum(b, total);
}

static void before_particles(void *memory, struct simulation *sim)
{
    among_grains_set_forces(memory, sim->dt);
}

static int along(void *memory, struct simulation *sim, int steps)
{
    return among_grains_run(memory, sim, steps);
}

static void after_particles(void *memory, struct simulation *sim)
{
    (void)sim;
    among_grains_end(memory);
}

static void bodies_effect_state(void *memory, struct state *s)
{
    solid_bodies_state(memory, s);
}

static void bodies_effect_free(void *memory)
{
    solid_bodies_free(memory);
}

static const struct effect_mover mover = {.move = bodies_effect_move,
                                          .trouble = bodies_effect_trouble,
                                          .momentum = bodies_effect_momentum};

static const struct effect_mover mover_among_grains = {
    .move = bodies_effect_move,
    .along = along,
    .trouble = bodies_effect_trouble,
    .momentum = bodies_effect_momentum};

const struct effect bodies_effect_among_grains = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved, among particles",
    .equations = "EW18 1-4, LS section 5.5",
    .function = "among_grains_run",
    .before_particles = before_particles,
    .mover = &mover_among_grains,
    .after_particles = after_particles,
    .state = bodies_effect_state,
    .free = bodies_effect_free,
};

const struct effect bodies_effect = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved",
    .equations = "EW18 1-4",
    .function = "hold_fluid",
    .mover = &mover,
    .state = bodies_effect_state,
    .free = bodies_effect_free,
};
