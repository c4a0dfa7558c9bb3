/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/bodies_effect.h"

#include "coupling/effect.h"
#include "coupling/simulation.h"
#include "resolved/among/among_grains.h"
#include "resolved/body_motion.h"

static int bodies_effect_move(void *memory, struct simulation *sim)
{
    return body_motion_advance(memory, sim->dt);
}

static const char *bodies_effect_trouble(const void *memory)
{
    const struct solid_bodies *const b = memory;

    if (b->met)
        return "a body on a spring has come into another one, and contacts are "
               "those of spheres and clumps:";
    if (b->seal.inlet)
        return "bodies cut an inlet off from every outlet, and the flow would "
               "go through them; leave a gap of a cell or more:";
    if (b->seal.pushes)
        return "a body pushes the fluid into a part of the box without an "
               "outlet, and it would go through the bodies; leave a gap of a "
               "cell or more:";
    if (b->options.max_overlap > 0.0 && b->deepest > b->options.max_overlap)
        return "bodies lie in each other or in a wall by more of a diameter "
               "than bodies.max_overlap: what cannot give way presses on them, "
               "or they are too soft; try a smaller fluid.step with a higher "
               "bodies.stiffness:";
    return b->dem_report.lost > 0
               ? "a body left the box, or its velocity is no longer finite; "
                 "try a smaller fluid.step or a higher bodies.stiffness:"
               : NULL;
}

static void bodies_effect_momentum(const void *memory, double total[3])
{
    body_motion_add_momentum(memory, total);
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
                                          .failure = bodies_effect_trouble,
                                          .momentum = bodies_effect_momentum};

const struct effect bodies_effect = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved",
    .equations = "EW18 1-4",
    .function = "hold_fluid",
    .mover = &mover,
    .state = bodies_effect_state,
    .free = bodies_effect_free,
};

/* --- among ---------------------------------------------------------------- */

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

static const struct effect_mover among_mover = {
    .move = among_effect_move,
    .move_particles = among_effect_along,
    .failure = bodies_effect_trouble,
    .momentum = momentum};

const struct effect among_effect = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved, among particles",
    .equations = "EW18 1-4, LS section 5.5",
    .function = "among_grains_run",
    .before_particles = before_particles,
    .mover = &among_mover,
    .after_particles = after_particles,
    .state = bodies_effect_state,
    .free = bodies_effect_free,
};
