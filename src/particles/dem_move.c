/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/dem_inside.h"

#include <math.h>
#include <omp.h>

#include "particles/prescribed.h"
#include "particles/stride.h"

/* The contacts are chosen for about so many steps ahead. */
static const double steps_ahead = 12.0;

/* All functions here are called by every thread of the team. Each counts for
 * itself what all of them see: how far pairs may come closer [m] until the
 * contacts have to be chosen again, and how much of it is spent. */
struct reach {
    double margin, spent;
};

/* The time after k steps of this run, as walls and driven particles know it. */
static double time_after(const struct dem *dem, int k)
{
    return (double)(dem->tick + (dem->ticking ? k : 0)) * dem->options.step;
}

static struct stride stride(const struct dem *dem, double dt, double kick,
                            double drift)
{
    return (struct stride){.sweep = dem->sweep,
                           .constants = dem->constants,
                           .attractions = dem->options.attractions,
                           .n_attractions = dem->options.n_attractions,
                           .budget = dem->energy != NULL,
                           .driven = dem->ticking,
                           .t = time_after(dem, 0),
                           .dt = dt,
                           .kick = kick,
                           .drift = drift};
}

/* Loads alone; the springs move on by dt. Nobody is steered. */
static void load(const struct dem *dem, double dt)
{
    struct stride still = stride(dem, dt, 0.0, 0.0);

    still.driven = 0;
    stride_take(dem->neighbours, &still);
}

/* Whether a budget should book what springs have lost since they were seen
 * last, or look only. */
static void book(const struct dem *dem, int looks)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    if (dem->energy == NULL) return;
    for (int s = mine.first; s < mine.last; s++) {
        nb->strips[s].energy.looks = looks;
        if (nb->surfaces != NULL)
            surfaces_energy(nb->surfaces, s)->looks = looks;
    }
    neighbours_meet(nb);
}

/* Lists and forces for particles that were changed from outside; no time
 * passes. */
static int start(struct dem *dem, double *margin)
{
    *margin = neighbours_refresh(dem->neighbours, dem->least_margin);
    if (*margin < 0.0) return 1;
    book(dem, 1);
    load(dem, 0.0);
    book(dem, 0);
    return 0;
}

static void measure(struct dem *dem)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        if (nb->drive != NULL)
            driven_release(nb->drive, nb->bodies, nb->ps, own->begin, own->end);
        strip_measure(own, nb->bodies);
    }
}

/* The energy of now, and what has come since the last run. */
static void open_budget(struct dem *dem)
{
    struct energy *const e = dem->energy;

    measure(dem);
    neighbours_meet(dem->neighbours);
    if (omp_get_thread_num() == 0) {
        const struct energy before = *e;
        *e = energy_collect(dem->neighbours, dem->options.law->stored);
        e->brought = before.brought;
        e->brought += energy_residual(e) - energy_residual(&before);
    }
    neighbours_meet(dem->neighbours);
}

static void choose_contacts(struct dem *dem, struct reach *r, double closer)
{
    r->margin = neighbours_refresh(
        dem->neighbours, fmax(dem->least_margin, steps_ahead * closer));
    r->spent = 0.0;
}

/* Kick, drift, kick, drift, ...: the first drift follows the integrator's first
 * kick, each later one a whole kick, and the last kick brings the velocities to
 * the time of the places. Gives the steps done. */
static int leap(struct dem *dem, int steps, struct reach *r)
{
    const struct integrator *const by = dem->options.integrator;
    struct neighbours *const nb = dem->neighbours;
    const double dt = dem->options.step;
    const struct stride first = stride(dem, 0.0, by->first * dt, dt);
    const struct stride whole = stride(dem, dt, dt, dt);
    const struct stride last = stride(dem, dt, by->last * dt, 0.0);

    if (steps > 0) stride_move(nb, &first);
    for (int k = 0; k < steps; k++) {
        prescribed_move(nb, time_after(dem, k + 1));
        const double closer = 2.0 * neighbours_speed(nb) * dt; /* [LS 5.16] */
        r->spent += closer;
        if (r->spent > r->margin) choose_contacts(dem, r, closer);
        if (r->margin < 0.0) return k;
        struct stride now = k + 1 < steps ? whole : last;
        now.t = time_after(dem, k + 1);
        stride_take(nb, &now);
    }
    return steps;
}

static void predict(struct dem *dem, double dt)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        if (dem->energy != NULL)
            strip_work(own, nb->bodies, own->begin, own->end, 0.5 * dt);
        integrators_predict(dem->start, own, nb->bodies, dt);
    }
}

static void correct(struct dem *dem, double dt)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct strip *const own = &nb->strips[s];
        if (dem->energy != NULL)
            strip_work(own, nb->bodies, own->begin, own->end, 0.5 * dt);
        integrators_correct(dem->start, own, nb->bodies, dt);
    }
}

/* a(x, v), which leaves the springs as they are, and is kept. */
static void force_at_start(struct dem *dem)
{
    struct neighbours *const nb = dem->neighbours;
    const struct neighbours_share mine = neighbours_share(nb);

    load(dem, 0.0);
    for (int s = mine.first; s < mine.last; s++)
        integrators_keep(dem->start, &nb->strips[s], nb->bodies);
    neighbours_meet(nb);
}

/* Driven particles keep the velocity of a whole step through both of Heun's
 * halves, and so end where they should; dt = 0: the velocity of that time. */
static void steer(struct dem *dem, int k, double dt)
{
    struct neighbours *const nb = dem->neighbours;

    if (nb->drive == NULL || !dem->ticking) return;
    prescribed_steer(nb, time_after(dem, k), dt);
    neighbours_meet(nb);
}

/* Heun. The springs are drawn by half a step with the slip at its start, for
 * which the contacts are gone through once more, and by half a step with the
 * slip at x*, v*. The lists are for pairs that are near at the start. The
 * contact forces that a run leaves are those at x*, v*: to ask for them at the
 * end would let sliding springs give way once more. */
static int lean(struct dem *dem, int steps, struct reach *r)
{
    struct neighbours *const nb = dem->neighbours;
    const struct stride still = stride(dem, 0.0, 0.0, 0.0);
    const double dt = dem->options.step;
    int k = 0;

    stride_move(nb, &still); /* for the speeds */
    for (; k < steps; k++) {
        const double closer = 2.0 * neighbours_speed(nb) * dt;
        if (r->spent + closer > r->margin) choose_contacts(dem, r, closer);
        if (r->margin < 0.0) return k;
        steer(dem, k, dt);
        force_at_start(dem);
        load(dem, 0.5 * dt);
        predict(dem, dt);
        neighbours_meet(nb);
        prescribed_move(nb, time_after(dem, k + 1));
        load(dem, 0.5 * dt);
        correct(dem, dt);
        neighbours_meet(nb);
        r->spent += fmax(closer, 2.0 * neighbours_speed(nb) * dt);
    }
    steer(dem, steps, 0.0);
    return steps;
}

/* Gives the steps done, or -1 if a particle was lost before. */
static int move(struct dem *dem, int steps, struct reach *r)
{
    struct neighbours *const nb = dem->neighbours;

    prescribed_move(nb, time_after(dem, 0));
    if (dem->ticking) prescribed_steer(nb, time_after(dem, 0), 0.0);
    if (nb->stale && start(dem, &r->margin) != 0) return -1;
    if (dem->energy != NULL) open_budget(dem);
    return dem->options.integrator->predicts ? lean(dem, steps, r)
                                             : leap(dem, steps, r);
}

void dem_move(struct dem *dem, int steps)
{
    struct neighbours *const nb = dem->neighbours;
    struct reach r = {nb->margin, nb->spent};

    neighbours_fetch(nb);
    const int done = move(dem, steps, &r);
    if (done >= 0) {
        neighbours_look(nb);
        measure(dem);
    }
    neighbours_park(nb);
    neighbours_meet(nb);
    if (omp_get_thread_num() == 0 && done >= 0) {
        nb->margin = r.margin;
        nb->spent = r.spent;
        dem->done = done;
        dem->tick += dem->ticking ? done : 0;
    }
}
