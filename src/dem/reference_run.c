/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/interrupt.h"
#include "base/vector.h"
#include "dem/dem_method.h"
#include "dem/integrator.h"
#include "dem/reference.h"

/* The state of the method, dem->state. */
struct run {
    struct reference loop;
    struct energy unused; /* the budget of a run that asks for none */
    int stale;            /* [-] 1: particles were changed from outside */
};

static const char *reference_run_unsupported(const struct dem_options *o)
{
    if (o->n_surfaces > 0) return "surfaces";
    if (o->n_prescribed > 0) return "prescribed particles";
    if (o->method->no_contacts && o->n_attractions > 0)
        return "forces between particles at a distance";
    if (o->integrator != NULL && o->integrator->predicts)
        return "integrators that compute the forces twice";
    return NULL;
}

static int reference_run_create(struct dem *dem)
{
    const struct dem_options *const o = &dem->options;
    const int capacity = dem->ps->capacity;
    struct run *const run = dem->state = owner_create(sizeof *run);
    struct reference *const r = &run->loop;

    r->options = o;
    r->constants = dem->constants;
    r->box = box_domain_of(o->lo, o->hi, o->periodic);
    r->capacity = capacity;
    r->sphere = owner_zeroed(run, (size_t)capacity, sizeof *r->sphere);
    r->now.start = owner_ints(run, capacity + 1);
    r->before.start = owner_ints(run, capacity + 1);
    r->deepest = &dem->deepest;
    r->no_contacts = dem->method->no_contacts;
    if (dem->method == &reference_link_cells)
        r->cells = link_cells_create(capacity, &r->box);
    run->stale = 1;
    return 0;
}

static void reference_run_release(struct dem *dem)
{
    struct run *const run = dem->state;

    if (run == NULL) return;
    free(run->loop.now.list);
    free(run->loop.before.list);
    owner_free(run->loop.cells);
    owner_free(run);
}

static void reference_run_changed(struct dem *dem)
{
    struct run *const run = dem->state;
    run->stale = 1;
}

/* --- particles to spheres, and back --------------------------------------- */

static void reference_run_load(struct reference *r, const struct particles *ps)
{
    r->n = ps->n;
    r->id = ps->id;
    r->clumps = ps->clumps;
    if (ps->clumps != NULL) clumps_locate(ps);
    for (int i = 0; i < ps->n; i++) {
        struct sphere *const s = &r->sphere[i];
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};
        const double external[3] = {ps->ex[i], ps->ey[i], ps->ez[i]};
        memcpy(s->x, x, sizeof x);
        memcpy(s->v, v, sizeof v);
        memcpy(s->w, w, sizeof w);
        memcpy(s->external, external, sizeof external);
        s->R = 0.5 * ps->d[i];
        s->m = ps->m[i];
        s->material = ps->material != NULL ? ps->material[i] : 0;
        s->clump = ps->clumps != NULL ? ps->clumps->of[ps->id[i]] : -1;
    }
    reference_put_balls(r);
}

static void reference_run_store(const struct reference *r, struct particles *ps)
{
    for (int i = 0; i < r->n; i++) {
        const struct sphere *const s = &r->sphere[i];
        ps->x[i] = box_domain_inside(&r->box, 0, s->x[0]);
        ps->y[i] = box_domain_inside(&r->box, 1, s->x[1]);
        ps->z[i] = box_domain_inside(&r->box, 2, s->x[2]);
        ps->vx[i] = s->v[0], ps->vy[i] = s->v[1], ps->vz[i] = s->v[2];
        ps->wx[i] = s->w[0], ps->wy[i] = s->w[1], ps->wz[i] = s->w[2];
        ps->cfx[i] = s->all.F[0], ps->cfy[i] = s->all.F[1],
        ps->cfz[i] = s->all.F[2];
    }
}

/* --- motion --------------------------------------------------------------- */

/* [kg] with the added mass. */
static double effective_mass(const struct sphere *s, const struct particles *ps,
                             int i)
{
    return s->m + (ps->drag_coefficient != NULL ? ps->added_mass[i] : 0.0);
}

/* What a kick of dt changes [LS 4.1-4.3]: dv = F/m dt and domega = T/I dt, or
 * with a drag -k v and an added mass as in implicit_drag.h; `drag` is the
 * impulse [N s] of that. */
struct change {
    double v[3], w[3], drag[3];
};

static struct change change_of(const struct sphere *s,
                               const struct particles *ps, int i, double dt)
{
    const int drag = ps->drag_coefficient != NULL;
    const double m = effective_mass(s, ps, i);
    const double I = 0.4 * s->m * s->R * s->R;
    const double rate = drag ? ps->drag_coefficient[i] / m : 0.0;
    const double gain = implicit_drag_gain(rate * dt);
    struct change d;

    for (int k = 0; k < 3; k++) {
        const double a = (s->all.F[k] + s->external[k]) / m;
        d.v[k] = gain * (a - rate * s->v[k]) * dt;
        d.w[k] = s->all.T[k] / I * dt;
        d.drag[k] = drag ? m * (d.v[k] - a * dt) : 0.0;
    }
    return d;
}

/* The same of a ball whose clump has had the kick. */
static struct change change_of_ball(const struct reference *r,
                                    const struct sphere *s)
{
    const struct clump *const c = &r->clumps->item[s->clump];
    const struct clump_pose at = clumps_pose(c);
    struct change d = {.drag = {0.0}};
    double arm[3], around[3];

    reference_arm(r, c, s, arm);
    vector_cross(at.w, arm, around);
    vector_between(c->v, s->v, d.v);
    vector_along(d.v, 1.0, around, d.v);
    vector_between(at.w, s->w, d.w);
    return d;
}

static double load_work(const struct loads *load, const double v[3],
                        const double w[3])
{
    return vector_dot(load->F, v) + vector_dot(load->T, w);
}

/* The work in the part of a kick of dt from `from` to `to` [-], with the mean
 * velocity in it (energy.h). */
static void reference_run_count(struct energy *e, const struct sphere *s,
                                const struct change *d, double dt, double from,
                                double to)
{
    const struct loads *const part = s->part;
    const double h = (to - from) * dt, middle = 0.5 * (from + to);
    double v[3], w[3];

    vector_along(s->v, middle, d->v, v);
    vector_along(s->w, middle, d->w, w);
    e->damped_n -= h * vector_dot(part[ENERGY_DASHPOTS].F, v);
    e->rolled -= h * vector_dot(part[ENERGY_DASHPOTS].T, w);
    e->damped_t -= h * load_work(&part[ENERGY_DASHPOTS_T], v, w);
    e->released -= h * load_work(&part[ENERGY_FRICTION], v, w);
    e->attracted += h * vector_dot(part[ENERGY_ATTRACTIONS].F, v);
    e->work +=
        h * vector_dot(s->external, v) + (to - from) * vector_dot(d->drag, v);
}

/* A kick of dt; the budget counts it from `from` [-] of it on. */
static void reference_run_kick(struct reference *r, const struct particles *ps,
                               double dt, double from)
{
    reference_kick_clumps(r, dt);
    for (int i = 0; i < r->n; i++) {
        struct sphere *const s = &r->sphere[i];
        const struct change d =
            s->clump < 0 ? change_of(s, ps, i, dt) : change_of_ball(r, s);

        if (r->budget) reference_run_count(r->energy, s, &d, dt, from, 1.0);
        for (int k = 0; k < 3; k++) {
            s->v[k] += d.v[k];
            s->w[k] += d.w[k];
            if (ps->drag_coefficient != NULL)
                ps->drag_impulse[3 * i + k] += d.drag[k];
        }
    }
}

static void reference_run_drift(struct reference *r, double dt)
{
    for (int i = 0; i < r->n; i++)
        vector_along(r->sphere[i].x, dt, r->sphere[i].v, r->sphere[i].x);
    for (int c = 0; r->clumps != NULL && c < r->clumps->n; c++)
        clumps_drift(&r->clumps->item[c], &r->box, dt);
    reference_put_balls(r);
}

/* e of the sphere's material against that of the walls. */
static double restitution_at(const struct reference *r, const struct sphere *s)
{
    const struct materials *const all = r->options->materials;
    const struct material *const m = &r->options->material;

    if (all == NULL) return m->restitution;
    return materials_pair(m, all, s->material, all->wall).restitution;
}

/* Without contacts a wall reflects a sphere that approaches it at once, v_n to
 * -e v_n, so that the step need not resolve the impact: its distance beyond the
 * wall becomes e times that distance in front of it, as it would without
 * forces. The spin is unchanged. */
static void rebound(struct reference *r, const struct particles *ps, int i)
{
    struct sphere *const s = &r->sphere[i];
    const double e = restitution_at(r, s), m = effective_mass(s, ps, i);

    for (int w = 0; w < 6; w++) {
        const int k = w / 2;
        const double into = w % 2 ? 1.0 : -1.0;
        const double gap = box_domain_gap(&r->box, w, s->x) - s->R;
        if (r->box.periodic[k] || gap >= 0.0 || into * s->v[k] <= 0.0) continue;
        r->energy->damped_n += 0.5 * m * (1.0 - e * e) * s->v[k] * s->v[k];
        s->x[k] += (1.0 + e) * into * gap;
        s->v[k] *= -e;
    }
}

/* Kick, drift, kick, drift, ...: the first drift follows the integrator's first
 * kick, each later one a whole kick, and after the last kick velocities and
 * positions are at the same time; where the velocity lags behind (Euler) the
 * budget counts the part of the next kick that brings it there. */
static void take_steps(const struct dem *dem, struct reference *r, int steps,
                       struct dem_report *report)
{
    const struct particles *const ps = dem->ps;
    const struct integrator *const by = r->options->integrator;
    const double dt = r->options->step, lag = integrator_lag(by);

    for (int k = 0; k < steps; k++) {
        reference_run_kick(r, ps, k == 0 ? by->first * dt : dt,
                           k == 0 ? lag / by->first : 0.0);
        reference_run_drift(r, dt);
        for (int i = 0; i < r->n && r->no_contacts; i++)
            rebound(r, ps, i);
        if (reference_check_lost(r, report) > 0) return;
        report->crossing = reference_crossing(r, dt);
        if (report->crossing.found) return;
        /* reference_forces subtracts the energy that is left in the springs */
        r->energy->released += r->energy->tangential;
        reference_forces(r, dt);
        report->steps++;
        if (dem_looks(dem, k) && interrupt_arrived()) return;
    }
    if (steps == 0) return;
    reference_run_kick(r, ps, by->last * dt, 0.0);
    for (int i = 0; i < r->n && r->budget && lag > 0.0; i++) {
        const struct change d = change_of(&r->sphere[i], ps, i, dt);
        reference_run_count(r->energy, &r->sphere[i], &d, dt, 0.0, lag);
    }
}

/* --- the sums of a run ---------------------------------------------------- */

/* The forces after a change of the particles; nothing is counted as released.
 */
static void reference_run_start(struct reference *r)
{
    const double released = r->energy->released;

    reference_forces(r, 0.0);
    r->energy->released = released;
}

/* At the time of the positions. */
static double kinetic_energy(const struct reference *r,
                             const struct particles *ps)
{
    const double dt = r->options->step;
    const double lag = integrator_lag(r->options->integrator);
    double sum, turning;

    clumps_energy(r->clumps, &sum, &turning);
    sum += turning;
    for (int i = 0; i < r->n; i++) {
        const struct sphere *const s = &r->sphere[i];
        const struct change d = change_of(s, ps, i, dt);
        const double m = effective_mass(s, ps, i);
        double v[3], w[3];
        if (s->clump >= 0) continue;
        vector_along(s->v, lag, d.v, v);
        vector_along(s->w, lag, d.w, w);
        sum += 0.5 * m * vector_dot(v, v) +
               0.2 * s->m * s->R * s->R * vector_dot(w, w);
    }
    return sum;
}

static void reference_run_measure(const struct reference *r,
                                  struct dem_report *report)
{
    report->contacts = r->now.n;
    report->max_overlap = r->max_overlap;
    report->rebuilds = r->sorts;
    clumps_energy(r->clumps, &report->translation, &report->rotation);
    for (int i = 0; i < r->n; i++) {
        const struct sphere *const s = &r->sphere[i];
        report->max_speed = fmax(report->max_speed, vector_length(s->v));
        if (s->clump >= 0) continue;
        report->translation += 0.5 * s->m * vector_dot(s->v, s->v);
        report->rotation += 0.2 * s->m * s->R * s->R * vector_dot(s->w, s->w);
    }
}

static void reference_run_steps(struct dem *dem, int steps,
                                struct dem_report *report)
{
    struct run *const run = dem->state;
    struct reference *const r = &run->loop;
    struct energy *const e = dem->energy != NULL ? dem->energy : &run->unused;
    const double before = energy_residual(e);

    *report = (struct dem_report){.steps = 0};
    r->energy = e;
    r->budget = dem->energy != NULL;
    r->max_overlap = 0.0;
    r->sorts = 0;
    reference_run_load(r, dem->ps);
    if (reference_check_lost(r, report) == 0) {
        if (run->stale) reference_run_start(r);
        run->stale = 0;
        e->kinetic = kinetic_energy(r, dem->ps);
        e->added += energy_residual(e) - before;
        take_steps(dem, r, steps, report);
        e->kinetic = kinetic_energy(r, dem->ps);
    }
    reference_run_store(r, dem->ps);
    reference_run_measure(r, report);
    dem->motion_steps += dem->motion_on ? report->steps : 0;
}

/* --- state ------------------------------------------------------------- */

static void reference_run_histories(struct histories *t, int n_spheres,
                                    struct state *s)
{
    state_begin(s, "contacts");
    state_count(s, "count", &t->n, INT_MAX);
    if (s->loading && !s->failed) {
        free(t->list);
        t->capacity = t->n;
        t->list = alloc_zeroed((size_t)t->n, sizeof *t->list);
    }
    state_indices(s, "start", t->start, n_spheres + 1L, 0, t->n);
    state_demand(s, state_rises(t->start, n_spheres + 1L, 0, t->n),
                 "lists that do not follow each other");
    const size_t size = sizeof *t->list;
    state_indices_of(s, "partner", &t->list->partner, size, t->n, -6,
                     n_spheres - 1);
    state_reals_of(s, "xi", "m", t->list->xi, size, t->n, 3);
    state_reals_of(s, "roll_angle", "rad", t->list->roll_angle, size, t->n, 3);
    state_end(s);
}

/* The loads of the last step act in the first half kick of the next one. */
static void reference_run_visit(struct dem *dem, struct state *s)
{
    struct run *const run = dem->state;
    struct reference *const r = &run->loop;
    const int n = dem->ps->n;
    struct sphere *const all = r->sphere;

    state_whole(s, "stale", "-", &run->stale);
    reference_run_histories(&r->now, n, s);
    state_reals_of(s, "force", "N", all->all.F, sizeof *all, n, 3);
    state_reals_of(s, "torque", "N m", all->all.T, sizeof *all, n, 3);
    for (int k = 0; k < ENERGY_PARTS; k++) {
        state_begin_number(s, "part", k);
        state_reals_of(s, "force", "N", all->part[k].F, sizeof *all, n, 3);
        state_reals_of(s, "torque", "N m", all->part[k].T, sizeof *all, n, 3);
        state_end(s);
    }
}

/* --- histories ------------------------------------------------------------ */

static struct dem_history *histories(struct dem *dem, int *n)
{
    const struct histories *const now = &((struct run *)dem->state)->loop.now;
    const int *const id = dem->ps->id;
    struct dem_history *const list = alloc_zeroed((size_t)now->n, sizeof *list);
    int i = 0;

    *n = now->n;
    for (int q = 0; q < now->n; q++) {
        while (q >= now->start[i + 1])
            i++;
        const struct history *const t = &now->list[q];
        list[q].id = id[i];
        list[q].other = t->partner < 0 ? t->partner : id[t->partner];
        memcpy(list[q].xi, t->xi, sizeof t->xi);
        memcpy(list[q].roll_angle, t->roll_angle, sizeof t->roll_angle);
    }
    return list;
}

/* Returns the owner of an entry, the sphere with the smaller index, and fills
 * in its history: xi and theta change sign with the owner. */
static int owner_and_history(const struct dem_history *spring, const int *index,
                             struct history *history)
{
    const int i = index[spring->id];
    const int j = spring->other < 0 ? spring->other : index[spring->other];
    const double sign = j >= 0 && j < i ? -1.0 : 1.0;

    history->partner = sign < 0.0 ? i : j;
    for (int k = 0; k < 3; k++) {
        history->xi[k] = sign * spring->xi[k];
        history->roll_angle[k] = sign * spring->roll_angle[k];
    }
    return sign < 0.0 ? j : i;
}

static void restore_histories(struct dem *dem, const struct dem_history *list,
                              int n, const int *index)
{
    struct run *const run = dem->state;
    struct histories *const now = &run->loop.now;
    struct history history;

    if (run->loop.no_contacts) return;
    free(now->list);
    now->list = alloc_zeroed((size_t)n, sizeof *now->list);
    now->n = now->capacity = n;
    memset(now->start, 0, ((size_t)run->loop.capacity + 1) * sizeof(int));
    for (int q = 0; q < n; q++)
        now->start[owner_and_history(&list[q], index, &history)]++;
    for (int i = 0, sum = 0; i <= run->loop.capacity; i++) {
        sum += now->start[i];
        now->start[i] = sum; /* the end of sphere i; becomes its start */
    }
    for (int q = n - 1; q >= 0; q--) {
        const int owner = owner_and_history(&list[q], index, &history);
        now->list[--now->start[owner]] = history;
    }
    run->stale = 1;
}

/* They differ by their candidates alone (create); the last has none. */
#define REFERENCE_FUNCTIONS                                                    \
    .unsupported = reference_run_unsupported, .create = reference_run_create,  \
    .free = reference_run_release, .run = reference_run_steps,                 \
    .changed = reference_run_changed, .visit = reference_run_visit,            \
    .histories = histories, .restore_histories = restore_histories

const struct dem_method reference_all_pairs = {
    .name = "all-pairs",
    .what = "every pair in every step, by the loop that is easiest to read",
    .equations = "LS 4.1-4.3",
    .function = "reference_forces",
    REFERENCE_FUNCTIONS};

const struct dem_method reference_link_cells = {
    .name = "link-cells",
    .what = "pairs of neighbouring cells in every step, by the same loop",
    .equations = "LS section 5.2.2",
    .function = "link_cells_around",
    REFERENCE_FUNCTIONS};

/* For one- and two-way coupling: the walls reflect a sphere (rebound). */
const struct dem_method reference_no_contacts = {
    .name = "none",
    .what = "no contacts between particles; walls reflect them",
    .equations = "LS 4.1",
    .function = "rebound",
    .no_contacts = 1,
    REFERENCE_FUNCTIONS};
