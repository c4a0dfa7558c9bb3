/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/among/among_effect.h"

#include "coupling/effect.h"
#include "coupling/simulation.h"
#include "resolved/among/among_grains.h"
#include "resolved/bodies_effect.h"
#include "resolved/body_motion.h"

static void momentum(const void *memory, double total[3])
{
    body_motion_add_momentum(memory, total);
    among_grains_add_momentum(memory, total);
}

static void before_particles(void *memory, struct simulation *sim)
{
    among_grains_set_forces(memory, sim->dt);
}

static int among_effect_along(void *memory, struct simulation *sim, int steps)
{
    return among_grains_run(memory, sim, steps);
}

static void after_particles(void *memory, struct simulation *sim)
{
    (void)sim;
    among_grains_end(memory);
}

/* They have moved along with the particles. */
static int among_effect_move(void *memory, struct simulation *sim)
{
    (void)memory, (void)sim;
    return 0;
}

static const struct effect_mover mover = {.move = among_effect_move,
                                          .move_particles = among_effect_along,
                                          .failure = bodies_effect_trouble,
                                          .momentum = momentum};

const struct effect among_effect = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved, among particles",
    .equations = "EW18 1-4, LS section 5.5",
    .function = "among_grains_run",
    .before_particles = before_particles,
    .mover = &mover,
    .after_particles = after_particles,
    .state = bodies_effect_state,
    .free = bodies_effect_free,
};
