/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/fast.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/interrupt.h"
#include "dem/fast/neighbours.h"

/* Number of steps for which contacts are chosen ahead. */
static const double steps_ahead = 12.0;

/* All functions here are called by every thread of the team. Each thread has
 * its own copy of the margin [m] by which gaps may decrease before the contacts
 * are chosen again, and of the part of it that is used. */
struct contact_margin {
    double margin, used;
};

/* The time after k steps of this run, for the prescribed motions. */
static double time_after(const struct dem *dem, int k)
{
    return (double)(dem->motion_steps + (dem->motion_on ? k : 0)) *
           dem->options.step;
}

static struct step_parameters step_parameters(const struct dem *dem, double dt,
                                              double kick, double drift)
{
    return (struct step_parameters){.constants = dem->constants,
                                    .attractions = dem->options.attractions,
                                    .n_attractions = dem->options.n_attractions,
                                    .budget = dem->energy != NULL,
                                    .prescribed = dem->motion_on,
                                    .t = time_after(dem, 0),
                                    .dt = dt,
                                    .kick = kick,
                                    .drift = drift};
}

/* Computes the loads alone; the tangential displacements advance by dt.
 * Prescribed velocities are not set. */
static void compute_loads(const struct dem *dem, double dt)
{
    struct step_parameters still = step_parameters(dem, dt, 0.0, 0.0);

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
            surfaces_energy(nb->surfaces, s)->skip_release = skip;
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

/* Gives surfaces under load their velocity for step k. */
static void follow_loads(const struct dem *dem, int k)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    if (nb->surfaces == NULL || !nb->surfaces->scene.loaded || !dem->motion_on)
        return;
    if (omp_get_thread_num() == 0)
        surfaces_follow_loads(nb->surfaces, time_after(dem, k));
    neighbours_barrier(nb);
}

/* Puts the surfaces where they are at time t [s]. */
static void move_surfaces(const struct neighbours *nb, double t)
{
    const struct chunk_range mine = neighbours_static_range(nb);

    if (nb->surfaces == NULL) return;
    for (int s = mine.first; s < mine.last; s++)
        surfaces_move(nb->surfaces, s, t);
}

/* Makes the prescribed particles ready for a drift of dt from there [s]. */
static void set_prescribed(const struct neighbours *nb, double t, double dt)
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
    *margin =
        neighbours_refresh(fast_of(dem)->neighbours, fast_of(dem)->min_margin);
    if (*margin < 0.0) return 1;
    set_skip_release(dem, 1);
    compute_loads(dem, 0.0);
    set_skip_release(dem, 0);
    push_surfaces(dem, 1.0);
    return 0;
}

static void fast_move_measure(struct dem *dem)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        if (dem->energy != NULL)
            chunk_measure_ahead(own, nb->rows,
                                integrator_lag(dem->options.integrator));
        if (nb->prescribed != NULL)
            prescribed_particles_restore_mass(nb->prescribed, nb->rows, nb->ps,
                                              own->begin, own->end);
        chunk_measure(own, nb->rows);
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

static void choose_contacts(struct dem *dem, struct contact_margin *r,
                            double closer)
{
    r->margin = neighbours_refresh(
        fast_of(dem)->neighbours,
        fmax(fast_of(dem)->min_margin, steps_ahead * closer));
    r->used = 0.0;
}

/* 1 if two have crossed in the last drift, in which a gap became smaller by
 * `closer` [m] at most: where that is less than the smallest diameter, no two
 * can have. */
static int is_crossed(const struct dem *dem, double closer)
{
    struct fast *const fast = fast_of(dem);

    if (!(closer > fast->neighbours->smallest)) return 0;
    if (omp_get_thread_num() == 0)
        fast->crossing =
            neighbours_crossing(fast->neighbours, dem->options.step);
    neighbours_barrier(fast->neighbours);
    return fast->crossing.found;
}

/* 1 if a signal ends the run after step k: one thread looks for all. */
static int is_interrupted(const struct dem *dem, int k)
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

/* Kick, drift, kick, drift, ...: the first drift follows the integrator's first
 * kick, each later one a whole kick, and after the last kick velocities and
 * positions are at the same time. Returns the number of steps done. */
static int verlet_steps(struct dem *dem, int steps, struct contact_margin *r)
{
    const struct integrator *const by = dem->options.integrator;
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const double dt = dem->options.step;
    struct step_parameters first =
        step_parameters(dem, 0.0, by->first * dt, dt);
    const struct step_parameters whole = step_parameters(dem, dt, dt, dt);
    const struct step_parameters last =
        step_parameters(dem, dt, by->last * dt, 0.0);

    first.from = integrator_lag(by) / by->first;
    if (steps > 0) chunk_step_move(nb, &first);
    for (int k = 0; k < steps; k++) {
        follow_loads(dem, k);
        move_surfaces(nb, time_after(dem, k + 1));
        const double closer = 2.0 * neighbours_speed(nb) * dt; /* [LS 5.16] */
        r->used += closer;
        if (is_crossed(dem, closer)) return k;
        if (r->used > r->margin) choose_contacts(dem, r, closer);
        if (r->margin < 0.0) return k;
        struct step_parameters now = k + 1 < steps ? whole : last;
        now.t = time_after(dem, k + 1);
        chunk_step_load_and_move(nb, &now);
        if (is_interrupted(dem, k)) return k + 1;
    }
    if (steps > 0) count_ahead(dem);
    return steps;
}

/* --- Heun's method (integrator.h) ----------------------------------------- */

const struct integrator integrators_heun = {
    .name = "heun",
    .what = "second order, also with damping; the energy drifts upward",
    .equations = "LS section 4.2",
    .function = "heun_correct",
    .predicts = 1,
};

static void heun_save_start(const struct heun *h, const struct chunk *s,
                            const struct rows *b)
{
    const size_t n = (size_t)(s->end - s->begin);

    if (n == 0) return;
    memcpy(&h->place[s->begin], &b->place[s->begin], n * sizeof *h->place);
    memcpy(&h->motion[s->begin], &b->motion[s->begin], n * sizeof *h->motion);
    memcpy(&h->load[s->begin], s->load, n * sizeof *h->load);
    if (h->part != NULL)
        memcpy(&h->part[s->begin], s->part, n * sizeof *h->part);
}

/* Of component k: dv/dt, and d(R omega)/dt (rows.c). */
static double rate_of_v(const struct row_load *load, const double a[4],
                        double per_m, int k)
{
    return load->F[k] * per_m + a[k];
}

static double rate_of_s(const struct row_load *load, double per_m, int k)
{
    return -2.5 * load->turn[k] * per_m;
}

static void heun_predict(const struct heun *h, const struct chunk *s,
                         struct rows *b, double dt)
{
    for (int i = s->begin; i < s->end; i++) {
        struct row_motion *const m = &b->motion[i];
        const struct row_load *const load = &h->load[i];

        for (int k = 0; k < 3; k++) {
            b->place[i].x[k] += m->v[k] * dt;
            m->v[k] += rate_of_v(load, b->acceleration[i], m->per_m, k) * dt;
            m->s[k] += rate_of_s(load, m->per_m, k) * dt;
        }
    }
}

static void heun_correct(const struct heun *h, struct chunk *s, struct rows *b,
                         double dt)
{
    memset(s->max_speed, 0, sizeof s->max_speed);
    for (int i = s->begin; i < s->end; i++) {
        const struct row_motion *const at_start = &h->motion[i];
        const struct row_load *const first = &h->load[i];
        const struct row_load *const second = &s->load[i - s->begin];
        const double *const a = b->acceleration[i];
        struct row_motion *const m = &b->motion[i];

        for (int k = 0; k < 3; k++) {
            const double ahead = m->v[k], per_m = m->per_m;
            b->place[i].x[k] =
                h->place[i].x[k] + 0.5 * dt * (at_start->v[k] + ahead);
            m->v[k] = at_start->v[k] + 0.5 * dt *
                                           (rate_of_v(first, a, per_m, k) +
                                            rate_of_v(second, a, per_m, k));
            m->s[k] = at_start->s[k] + 0.5 * dt *
                                           (rate_of_s(first, per_m, k) +
                                            rate_of_s(second, per_m, k));
            s->max_speed[k] = fmax(s->max_speed[k], fabs(ahead));
            s->max_speed[k] = fmax(s->max_speed[k], fabs(m->v[k]));
        }
    }
}

static void predict(struct dem *dem, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        heun_predict(&fast_of(dem)->heun, own, nb->rows, dt);
    }
}

/* The loads of the start and those at x*, v* act for half a step each, with the
 * velocities that they are for. */
static void count_heun(struct dem *dem, int s, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    struct heun *const h = &fast_of(dem)->heun;
    struct chunk *const own = &nb->chunks[s];
    const double half = 0.5 * dt;
    const struct chunk_kick first = {
        half, 0.0, 1.0, h->motion, h->motion, h->part + own->begin};
    const struct chunk_kick second = {
        half, 0.0, 1.0, nb->rows->motion, nb->rows->motion, own->part};

    chunk_count_kick(own, nb->rows, &first);
    chunk_count_kick(own, nb->rows, &second);
    if (nb->surfaces != NULL)
        surface_contacts_count(&nb->surfaces->chunk[s], half);
}

static void fast_move_correct(struct dem *dem, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        if (dem->energy != NULL) count_heun(dem, s, dt);
        heun_correct(&fast_of(dem)->heun, own, nb->rows, dt);
    }
}

/* Computes a(x, v) without changing the tangential displacements, and stores
 * it. */
static void force_at_start(struct dem *dem)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    compute_loads(dem, 0.0);
    for (int s = mine.first; s < mine.last; s++) {
        heun_save_start(&fast_of(dem)->heun, &nb->chunks[s], nb->rows);
        if (dem->energy != NULL && nb->surfaces != NULL)
            surface_contacts_count(&nb->surfaces->chunk[s],
                                   0.5 * dem->options.step);
    }
    neighbours_barrier(nb);
}

/* Prescribed particles have the mean velocity of the step in both of Heun's
 * halves, and so end at the prescribed position; dt = 0: the velocity of that
 * time. */
static void fast_move_set_prescribed(struct dem *dem, int k, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    if (nb->prescribed == NULL || !dem->motion_on) return;
    set_prescribed(nb, time_after(dem, k), dt);
    neighbours_barrier(nb);
}

/* Heun's method. The tangential displacements advance by half a step with the
 * slip at the start, for which the contacts are computed once more, and by half
 * a step with the slip at x*, v*. The lists contain the pairs that are near at
 * the start. The contact forces at the end of a run are those at x*, v*,
 * because computing them again would reduce sliding springs once more. */
static int heun_steps(struct dem *dem, int steps, struct contact_margin *r)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct step_parameters still = step_parameters(dem, 0.0, 0.0, 0.0);
    const double dt = dem->options.step;
    int k = 0;

    chunk_step_move(nb, &still); /* for the speeds */
    for (; k < steps; k++) {
        const double closer = 2.0 * neighbours_speed(nb) * dt;
        if (is_crossed(dem, closer)) return k;
        if (r->used + closer > r->margin) choose_contacts(dem, r, closer);
        if (r->margin < 0.0) return k;
        fast_move_set_prescribed(dem, k, dt);
        follow_loads(dem, k);
        force_at_start(dem);
        compute_loads(dem, 0.5 * dt);
        predict(dem, dt);
        neighbours_barrier(nb);
        move_surfaces(nb, time_after(dem, k + 1));
        compute_loads(dem, 0.5 * dt);
        fast_move_correct(dem, dt);
        neighbours_barrier(nb);
        r->used += fmax(closer, 2.0 * neighbours_speed(nb) * dt);
        if (is_interrupted(dem, k)) return k + 1;
    }
    fast_move_set_prescribed(dem, steps, 0.0);
    return steps;
}

/* Returns the number of steps done, or -1 if a particle was lost before. */
static int fast_move_move(struct dem *dem, int steps, struct contact_margin *r)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    move_surfaces(nb, time_after(dem, 0));
    if (dem->motion_on) set_prescribed(nb, time_after(dem, 0), 0.0);
    if (nb->stale && fast_move_start(dem, &r->margin) != 0) return -1;
    if (dem->energy != NULL) begin_budget(dem);
    return dem->options.integrator->predicts ? heun_steps(dem, steps, r)
                                             : verlet_steps(dem, steps, r);
}

void fast_move(struct dem *dem, int steps)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    struct contact_margin r = {nb->margin, nb->margin_used};

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
        fast_of(dem)->steps_done = done;
        dem->motion_steps += dem->motion_on ? done : 0;
    }
}
