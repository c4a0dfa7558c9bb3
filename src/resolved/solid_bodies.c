/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/solid_bodies.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "coupling/effect.h"
#include "coupling/simulation.h"
#include "fluid/systems.h"
#include "resolved/among/among_grains.h"
#include "resolved/body_cells.h"
#include "resolved/body_motion.h"
#include "resolved/mark.h"

const double solid_bodies_immovable = 1e60;

const struct body_method *const solid_bodies_methods[] = {
    &hold_method, &fraction_methods_fictitious, &fraction_methods_piso_ib,
    NULL};

struct solid_bodies *solid_bodies_create(int n, int cells, double rho,
                                         const struct solid_bodies_options *o)
{
    const struct body_method *const by =
        o->method != NULL ? o->method : solid_bodies_methods[0];
    struct solid_bodies *const b = owner_create(sizeof *b);
    double **const three[] = {&b->u_old,      &b->w_old,   &b->u_by_fluid,
                              &b->w_by_fluid, &b->impulse, &b->angular,
                              &b->force,      &b->torque,  &b->spring,
                              &b->anchor,     &b->inertia};

    b->options = *o;
    if (o->dem != NULL) b->contacts = *o->dem;
    b->lubrication = o->lubrication;
    b->rho = rho;
    b->ps = particles_create(n);
    particles_add_implicit_drag(b->ps);
    b->shape = owner_zeroed(b, (size_t)n, sizeof *b->shape);
    b->motion = owner_zeroed(b, (size_t)n, sizeof *b->motion);
    b->mass = owner_doubles(b, n);
    b->C_v = owner_doubles(b, n);
    b->C_spin = owner_doubles(b, n);
    b->volume = owner_doubles(b, n);
    for (size_t a = 0; a < sizeof three / sizeof three[0]; a++)
        *three[a] = owner_doubles(b, 3 * n);
    b->cells = cells;
    b->start = owner_ints(b, n);
    b->end = owner_ints(b, n);
    b->near = owner_ints(b, n);
    b->cell = owner_ints(b, cells);
    b->amid = owner_zeroed(b, (size_t)cells, sizeof *b->amid);
    b->body_of = owner_ints(b, cells);
    b->hold = owner_doubles(b, cells);
    b->hold_u = owner_doubles(b, 3 * cells);
    b->by_fraction = by->by_fraction;
    b->hooks = by->hooks;
    return b;
}

void solid_bodies_free(void *bodies)
{
    struct solid_bodies *const b = bodies;

    if (b == NULL) return;
    among_grains_free(b->among);
    dem_free(b->dem);
    for (int i = 0; i < b->ps->n; i++)
        body_outline_free(b->shape[i].outline);
    particles_free(b->ps);
    free(b->link);
    owner_free(b);
}

/* A box, or a cylinder along an axis, may be longer than the box of the flow.
 */
static double volume_within(const struct solid_bodies *b,
                            const struct body_shape *shape)
{
    const double *const lo = b->contacts.lo, *const hi = b->contacts.hi;
    struct body_shape cut = *shape;

    for (int k = 0; k < 3 && hi[k] > lo[k]; k++) {
        const double half = 0.5 * (hi[k] - lo[k]);
        if (shape->kind == BODY_BOX) cut.half[k] = fmin(cut.half[k], half);
        if (shape->kind == BODY_CYLINDER && body_shape_along(shape, k))
            cut.half[1] = fmin(cut.half[1], half);
    }
    return body_shape_volume(&cut);
}

int solid_bodies_add(struct solid_bodies *b, const struct body_shape *shape,
                     const double x[3], double density, enum body_motion motion)
{
    const double V = volume_within(b, shape);
    const int i = particles_add(b->ps, x, cbrt(6.0 * V / M_PI), density);

    b->shape[i] = *shape;
    b->motion[i] = motion;
    if (shape->kind == BODY_OUTLINE && b->turn == NULL) {
        b->turn = owner_doubles(b, 4 * b->ps->capacity);
        for (int k = 0; k < b->ps->capacity; k++)
            b->turn[4 * k] = 1.0;
    }
    b->volume[i] = V;
    b->C_v[i] = b->C_spin[i] = b->options.virtual_mass;
    b->mass[i] = b->ps->m[i];
    if (motion != BODY_FREE) b->ps->m[i] = solid_bodies_immovable;
    return i;
}

void solid_bodies_set_spring(struct solid_bodies *b, int i,
                             const double spring[3])
{
    const double x[3] = {b->ps->x[i], b->ps->y[i], b->ps->z[i]};

    b->motion[i] = BODY_SPRING;
    memcpy(&b->spring[3 * i], spring, sizeof x);
    memcpy(&b->anchor[3 * i], x, sizeof x);
}

int solid_bodies_hung(const struct solid_bodies *b, int i)
{
    return b->shape[i].kind == BODY_SPHERE && b->motion[i] == BODY_SPRING;
}

/* A free body from wall to wall can neither move along that axis nor tilt. */
static void look_for_walls(struct solid_bodies *b, const struct fluid *fl)
{
    const struct dem_options *const o = &b->contacts;

    for (int e = 0; e < 3 * b->ps->n; e++) {
        const int i = e / 3, k = e % 3;
        const double L = o->hi[k] - o->lo[k];
        if (b->motion[i] == BODY_FREE && b->shape[i].kind == BODY_OUTLINE &&
            !o->periodic[k] && L > 0.0 &&
            body_outline_spans(b->shape[i].outline, k, L,
                               L / fl->mesh->box.n[k]))
            b->shape[i].between |= 1 << k;
    }
}

int solid_bodies_begin(struct solid_bodies *b, struct fluid *fl)
{
    int free = 0;

    fl->immersed = &b->hooks;
    systems_own_residual(fl); /* the end of a step may solve for a pressure */
    b->mu = fl->options.mu;
    for (int i = 0; i < b->ps->n; i++) {
        const struct particles *const ps = b->ps;
        const double u[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
        free |= b->motion[i] == BODY_FREE;
        b->springs += b->motion[i] == BODY_SPRING;
        b->blocks += b->shape[i].kind != BODY_SPHERE || solid_bodies_hung(b, i);
        b->moves |= b->motion[i] != BODY_FIXED;
        memcpy(&b->u_old[3 * i], u, sizeof u);
        memcpy(&b->w_old[3 * i], w, sizeof w);
    }
    b->exit = owner_join(b, body_exit_create(b, fl));
    look_for_walls(b, fl);
    for (int c = 0; c < b->cells; c++)
        b->amid[c] = box_is_amid(&fl->mesh->box, c) ? 1 : 0;
    mark_start(b, fl);
    if (!free) return 0;
    /* To the dem of the spheres the others are points at their centres, which
     * no sphere comes to. */
    for (int i = 0; i < b->ps->n; i++)
        if (b->shape[i].kind != BODY_SPHERE || solid_bodies_hung(b, i))
            b->ps->d[i] *= 1e-3;
    b->dem = dem_create(b->ps, &b->contacts);
    return b->dem == NULL;
}

static void solid_bodies_state(void *bodies, struct state *s)
{
    struct solid_bodies *const b = bodies;
    const int n = b->ps->n;

    state_begin(s, "bodies");
    particles_state(b->ps, s);
    if (b->dem != NULL) dem_state(b->dem, s);
    state_whole(s, "held_cells", "-", &b->held);
    state_real(s, "deepest_overlap", "-", &b->deepest);
    state_reals(s, "velocity_before", "m/s", b->u_old, n, 3);
    state_reals(s, "velocity_by_fluid", "m/s", b->u_by_fluid, n, 3);
    state_reals(s, "spin_before", "rad/s", b->w_old, n, 3);
    state_reals(s, "spin_by_fluid", "rad/s", b->w_by_fluid, n, 3);
    state_reals(s, "orientation", "-", b->turn, n, 4);
    if (s->loading && b->turn != NULL) body_turn_load(b);
    state_reals(s, "force", "N", b->force, n, 3);
    state_reals(s, "torque", "N m", b->torque, n, 3);
    if (b->by_fraction)
        state_reals(s, "force_per_mass", "m/s^2", b->hold_u, b->cells, 3);
    if (b->exit != NULL) body_exit_state(b, s);
    if (b->among != NULL) among_grains_state(b, s);
    state_end(s);
    if (s->loading) b->dt_marked = 0.0; /* the links are made anew */
}

/* --- bodies effect -------------------------------------------------------- */

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

static const struct effect_mover mover = {.move = bodies_effect_move,
                                          .momentum = body_motion_add_momentum};

const struct effect bodies_effect = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved",
    .equations = "EW18 1-4",
    .function = "add_friction",
    .mover = &mover,
    .failure = bodies_effect_trouble,
    .state = solid_bodies_state,
    .free = solid_bodies_free,
};

/* --- among ---------------------------------------------------------------- */

static void momentum(const void *memory, double total[3])
{
    body_motion_add_momentum(memory, total);
    among_grains_add_momentum(memory, total);
}

static const struct effect_mover among_mover = {
    .move_particles = among_grains_run, .momentum = momentum};

const struct effect among_effect = {
    .name = "bodies",
    .what = "bodies with the flow around them resolved, among particles",
    .equations = "EW18 1-4, LS section 5.5",
    .function = "among_grains_run",
    .before_particles = among_grains_set_forces,
    .mover = &among_mover,
    .failure = bodies_effect_trouble,
    .after_particles = among_grains_end,
    .state = solid_bodies_state,
    .free = solid_bodies_free,
};
