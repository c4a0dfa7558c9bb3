/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/fast.h"

#include <math.h>
#include <omp.h>

#include "base/interrupt.h"
#include "dem/fast/neighbours.h"

/* The margin of a particle is what the fastest covers in so many steps, since
 * it may be hit, and what it covers itself in so many more. Surfaces are not
 * measured: with them all have the margin of the fastest. */
struct margin_steps {
    double of_fastest, ahead; /* [-] */
};

/* In n steps there are n times as many pairs that may touch, and 1/n choices a
 * step: the sum is least for an n that falls with the square root of the way
 * in a step. The factor was found by trial, and the optimum is flat. */
static struct margin_steps margin_steps_of(const struct dem *dem, double way)
{
    static const struct margin_steps constant = {1.5, 6.0};
    const struct fast *const fast = fast_of(dem);
    const double d = MARGIN_PARTS * fast->min_margin;
    const double n = 0.2 * sqrt(d / way);

    const int measured = way > 0.0 && fast->neighbours->surfaces == NULL;

    return measured && !dem->options.integrator->predicts
               ? (struct margin_steps){0.25 * n, n}
               : constant;
}

double fast_move_time(const struct dem *dem, int k)
{
    return (double)(dem->motion_steps + (dem->motion_on ? k : 0)) *
           dem->options.step;
}

struct step_parameters fast_move_parameters(const struct dem *dem, double dt,
                                            double kick, double drift)
{
    return (struct step_parameters){.constants = dem->constants,
                                    .attractions = dem->options.attractions,
                                    .n_attractions = dem->options.n_attractions,
                                    .budget = dem->energy != NULL,
                                    .prescribed = dem->motion_on,
                                    .t = fast_move_time(dem, 0),
                                    .dt = dt,
                                    .kick = kick,
                                    .drift = drift};
}

void fast_move_loads(const struct dem *dem, double dt)
{
    struct step_parameters still = fast_move_parameters(dem, dt, 0.0, 0.0);

    still.prescribed = 0;
    chunk_step_load_and_move(fast_of(dem)->neighbours, &still);
}

/* skip = 1: the budget does not count the energy that the springs have lost
 * since the last sweep as released. */
static void set_skip_release(const struct dem *dem, int skip)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    if (dem->energy == NULL) return;
    for (int s = mine.first; s < mine.last; s++) {
        nb->chunks[s].energy.skip_release = skip;
        if (nb->surfaces != NULL)
            nb->surfaces->chunk[s].pairs.energy.skip_release = skip;
    }
    neighbours_barrier(nb);
}

/* Adds the present loads over `kicks` times the first kick to the totals of
 * carried surfaces, which have a momentum of their own. */
static void push_surfaces(const struct dem *dem, double kicks)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);
    const double dt = dem->options.integrator->first * dem->options.step;

    if (nb->surfaces == NULL) return;
    for (int s = mine.first; s < mine.last; s++)
        surface_contacts_push(&nb->surfaces->chunk[s], &nb->surfaces->scene,
                              kicks * dt);
}

void fast_move_follow_loads(const struct dem *dem, double t)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    if (nb->surfaces == NULL || !nb->surfaces->scene.loaded || !dem->motion_on)
        return;
    if (omp_get_thread_num() == 0) surfaces_follow_loads(nb->surfaces, t);
    neighbours_barrier(nb);
}

void fast_move_surfaces(const struct neighbours *nb, double t)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    if (nb->surfaces == NULL) return;
    for (int s = mine.first; s < mine.last; s++)
        surfaces_move(nb->surfaces, s, t);
}

void fast_move_prescribed(const struct neighbours *nb, double t, double dt)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    if (nb->prescribed == NULL) return;
    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        own->energy.prescribed += prescribed_particles_set_velocities(
            nb->prescribed, nb->rows, nb->ps, own->begin, own->end, NULL, t, dt,
            0.0);
    }
}

/* Rebuilds lists and forces after particles were changed between runs; the time
 * does not advance. The first kick then has these loads in place of those of
 * the last step, which the totals of the surfaces contain already. */
static int fast_move_start(struct dem *dem, double *margin)
{
    push_surfaces(dem, -1.0);
    *margin = neighbours_refresh(fast_of(dem)->neighbours,
                                 0.5 * fast_of(dem)->min_margin, 0.0);
    if (*margin < 0.0) return 1;
    set_skip_release(dem, 1);
    fast_move_loads(dem, 0.0);
    set_skip_release(dem, 0);
    push_surfaces(dem, 1.0);
    return 0;
}

static void fast_move_measure(struct dem *dem)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);
    double moving, turning;

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        if (dem->energy != NULL)
            chunk_measure_ahead(own, nb->rows,
                                integrator_lag(dem->options.integrator));
        if (nb->prescribed != NULL)
            prescribed_particles_set_mass(nb->prescribed, nb->rows, nb->ps,
                                          own->begin, own->end, 0);
        chunk_measure(own, nb->rows);
        if (s > 0) continue;
        clumps_energy(dem->ps->clumps, &moving, &turning);
        own->measures.translation += moving;
        own->measures.rotation += turning;
    }
}

/* Computes the present energy, and the energy added since the last run. */
static void begin_budget(struct dem *dem)
{
    struct energy *const e = dem->energy;

    fast_move_measure(dem);
    neighbours_barrier(fast_of(dem)->neighbours);
    if (omp_get_thread_num() == 0) {
        const struct energy before = *e;
        *e = neighbours_energy(fast_of(dem)->neighbours);
        e->added = before.added;
        e->added += energy_residual(e) - energy_residual(&before);
    }
    neighbours_barrier(fast_of(dem)->neighbours);
}

void fast_move_choose(struct dem *dem, struct contact_margin *r, double closer)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const double v = neighbours_speed(nb);
    const int own = nb->surfaces == NULL && v > 0.0;
    const struct margin_steps by = margin_steps_of(dem, 0.5 * closer);
    const double steps = own ? by.of_fastest : by.ahead;

    r->used = 0.0;
    r->margin =
        nb->surfaces == NULL ? neighbours_margin_left(nb, r->looked) : -1.0;
    if (r->margin >= (dem->options.integrator->predicts ? closer : 0.0)) return;
    r->margin = neighbours_refresh(
        nb, 0.5 * fmax(fast_of(dem)->min_margin, steps * closer),
        own ? 0.5 * by.ahead * closer / v : 0.0);
}

int fast_move_crossed(const struct dem *dem, double closer)
{
    struct fast *const fast = fast_of(dem);

    if (!(closer > fast->neighbours->smallest)) return 0;
    if (omp_get_thread_num() == 0)
        fast->crossing =
            neighbours_crossing(fast->neighbours, dem->options.step);
    neighbours_barrier(fast->neighbours);
    return fast->crossing.found;
}

int fast_move_interrupted(const struct dem *dem, int k)
{
    struct fast *const fast = fast_of(dem);

    if (!dem_looks(dem, k)) return 0;
    if (omp_get_thread_num() == 0) fast->interrupted = interrupt_arrived();
    neighbours_barrier(fast->neighbours);
    return fast->interrupted;
}

/* Where the velocity lags behind the positions the budget counts the part of
 * the next kick that brings it there. */
static void count_ahead(struct dem *dem)
{
    const double lag = integrator_lag(dem->options.integrator);
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    if (dem->energy == NULL || lag == 0.0) return;
    for (int s = mine.first; s < mine.last; s++) {
        chunk_count_ahead(&nb->chunks[s], nb->rows, lag);
        if (nb->surfaces != NULL)
            surface_contacts_count(&nb->surfaces->chunk[s],
                                   lag * dem->options.step);
    }
    neighbours_barrier(nb);
}

/* 1 if the margins may be used up after a step in which gaps become smaller by
 * `closer` [m]: then it looks itself, block by block, while they are in the
 * cache. Balls of clumps move only after it. */
static int is_to_look(const struct neighbours *nb,
                      const struct contact_margin *r, double closer)
{
    return nb->surfaces == NULL && nb->ps->clumps == NULL &&
           r->used + closer > r->margin;
}

/* Kick, drift, kick, drift, ...: the first drift follows the integrator's first
 * kick, each later one a whole kick, and after the last kick velocities and
 * positions are at the same time. Returns the number of steps done. */
static int verlet_steps(struct dem *dem, int steps, struct contact_margin *r)
{
    const struct integrator *const by = dem->options.integrator;
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const double dt = dem->options.step;
    struct step_parameters first =
        fast_move_parameters(dem, 0.0, by->first * dt, dt);
    const struct step_parameters whole = fast_move_parameters(dem, dt, dt, dt);
    const struct step_parameters last =
        fast_move_parameters(dem, dt, by->last * dt, 0.0);

    first.from = integrator_lag(by) / by->first;
    r->looked = 0;
    if (steps > 0) chunk_step_move(nb, &first);
    for (int k = 0; k < steps; k++) {
        fast_move_follow_loads(dem, fast_move_time(dem, k));
        fast_move_surfaces(nb, fast_move_time(dem, k + 1));
        const double closer = 2.0 * neighbours_speed(nb) * dt; /* [LS 5.16] */
        r->used += closer;
        if (fast_move_crossed(dem, closer)) return k;
        if (r->used > r->margin) fast_move_choose(dem, r, closer);
        if (r->margin < 0.0) return k;
        struct step_parameters now = k + 1 < steps ? whole : last;
        now.passing = k + 1 < steps && !dem->motion_on;
        now.look = r->looked = k + 1 < steps && is_to_look(nb, r, closer);
        now.t = fast_move_time(dem, k + 1);
        chunk_step_load_and_move(nb, &now);
        if (fast_move_interrupted(dem, k)) return k + 1;
    }
    if (steps > 0) count_ahead(dem);
    return steps;
}

/* Returns the number of steps done, or -1 if a particle was lost before. */
static int fast_move_move(struct dem *dem, int steps, struct contact_margin *r)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    fast_move_surfaces(nb, fast_move_time(dem, 0));
    if (dem->motion_on) fast_move_prescribed(nb, fast_move_time(dem, 0), 0.0);
    if (nb->stale && fast_move_start(dem, &r->margin) != 0) return -1;
    if (dem->energy != NULL) begin_budget(dem);
    return dem->options.integrator->predicts ? heun_steps(dem, steps, r)
                                             : verlet_steps(dem, steps, r);
}

void fast_move(struct dem *dem, int steps)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    struct contact_margin r = {
        nb->margin, nb->margin_used, fast_of(dem)->adaptive.next, 0, 0, 0};

    neighbours_load(nb);
    const int done = fast_move_move(dem, steps, &r);
    if (done >= 0) {
        neighbours_check_lost(nb);
        fast_move_measure(dem);
    }
    neighbours_store(nb);
    neighbours_barrier(nb);
    if (omp_get_thread_num() == 0 && done >= 0) {
        nb->margin = r.margin;
        nb->margin_used = r.used;
        fast_of(dem)->adaptive.next = r.next;
        fast_of(dem)->parts = r.parts;
        fast_of(dem)->steps_done = done;
        dem->motion_steps += dem->motion_on ? done : 0;
    }
}
