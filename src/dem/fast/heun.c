/* SPDX-License-Identifier: GPL-3.0-or-later */
/* heun.c -- Heun's method (integrator.h), with steps of one length or in parts
 * that adapt.  Chapter "Insertion, removal and energy".
 *
 *   error = max |a* - a| dt/(2 V),   dt <- dt 0.9 sqrt(most/error)
 *
 * is what Heun's velocity differs from Euler's by, over the largest speed V of
 * any, or that of a fall by a diameter if it is larger. A step that only just
 * misses a contact has no error, and the next one is deep in it: so none
 * reaches the moment at which the first gap closes but the shortest, and those
 * after it grow from there. Thus no step need be taken back.
 */
#include "dem/fast/fast.h"

#include <math.h>
#include <omp.h>
#include <string.h>

#include "base/vector.h"
#include "dem/particles_setup.h"

const struct integrator integrators_heun = {
    .name = "heun",
    .what = "second order, also with damping; the energy drifts upward",
    .equations = "LS section 4.2",
    .function = "heun_correct",
    .predicts = 1,
};

static const struct key adaptive_keys[] = {
    {"particles.shortest_step", KEY_REAL, "s", "> 0", KEY_MODEL_REQUIRED,
     "shortest part that a step is split in: it is to resolve an impact",
     "LS section 4.2", "", KEY_AT(particles_setup, shortest_step),
     .mark = KEY_AFTER_BED},
    {"particles.step_error", KEY_REAL, "-", "> 0", "1e-4",
     "largest error of a velocity in such a part, over the highest speed",
     "LS section 4.2", "", KEY_AT(particles_setup, step_error),
     .mark = KEY_AFTER_BED},
    KEY_END};

const struct integrator integrators_adaptive_heun = {
    .name = "adaptive-heun",
    .what = "the same in parts of a step: as short as an impact needs",
    .equations = "LS section 4.2",
    .function = "adaptive_next",
    .keys = {adaptive_keys},
    .predicts = 1,
    .adapts = 1,
};

/* --- the length of a step that adapts ------------------------------------- */

/* Once in a run, by one thread. */
static void adaptive_begin(struct adaptive *a, const struct rows *b)
{
    double fall2 = 0.0;

    a->pull = 0.0;
    for (int i = 0; i < b->n; i++) {
        const double pull = vector_length(b->acceleration[i]);
        a->pull = fmax(a->pull, pull);
        fall2 = fmax(fall2, 4.0 * pull * b->place[i].R);
    }
    a->fall = sqrt(fall2);
}

/* The time in which particles of this speed and with what pulls them come
 * closer by an eighth of the skin, half of what the contacts are chosen for; at
 * most `length` [s]. */
static double adaptive_longest(const struct adaptive *a,
                               const struct neighbours *nb, double length)
{
    const double way = nb->skin / 16.0, speed = neighbours_speed(nb);
    const double divisor = speed + sqrt(speed * speed + 2.0 * a->pull * way);

    /* without a particle there is no skin, and nothing to come closer to */
    return divisor > 0.0 && way > 0.0 ? fmin(length, 2.0 * way / divisor)
                                      : length;
}

/* When a gap that closes at the speed c and the acceleration p is closed, or
 * would be without p, as for the prediction; one that is closed already does
 * not count. */
static double time_to_close(double gap, double c, double p)
{
    const double divisor = c + sqrt(c * c + 2.0 * fmax(p, 0.0) * gap);

    return gap > 0.0 && divisor > 0.0 ? 2.0 * gap / divisor : HUGE_VAL;
}

static double pair_closes(const struct rows *b, int i, int j)
{
    double x[3], v[3], p[3];

    vector_between(b->place[i].x, b->place[j].x, x);
    vector_between(b->motion[i].v, b->motion[j].v, v);
    vector_between(b->acceleration[i], b->acceleration[j], p);
    for (int k = 0; k < 3; k++)
        x[k] -= b->box.length[k] * rint(x[k] * b->box.inverse[k]);
    const double r = vector_length(x);
    return time_to_close(r - b->place[i].R - b->place[j].R,
                         -vector_dot(v, x) / r, -vector_dot(p, x) / r);
}

static double wall_closes(const struct rows *b, int i, int wall)
{
    const double to = wall % 2 ? 1.0 : -1.0;

    return time_to_close(rows_wall_gap(&b->box, &b->place[i], wall),
                         to * b->motion[i].v[wall / 2],
                         to * b->acceleration[i][wall / 2]);
}

static double face_closes(const struct surfaces *sf, int s,
                          const struct rows *b, int i,
                          const struct near_face *f)
{
    const struct pose *const p = &sf->chunk[s].pose[f->surface];
    double x[3], v[3];

    near_faces_image(f, b, i, x);
    const struct surface_hit h =
        surface_nearest_moved(&sf->scene.surface[f->surface], f->face, p, x);
    motion_velocity(p, h.q, v);
    vector_between(b->motion[i].v, v, v);
    return time_to_close(h.r - b->place[i].R, -vector_dot(v, h.n),
                         -vector_dot(b->acceleration[i], h.n));
}

/* When the first gap of chunk s closes [s]. */
static double adaptive_look(const struct neighbours *nb, int s)
{
    const struct chunk_contacts *const c = &nb->chunks[s].contacts;
    const struct rows *const b = nb->rows;
    double first = HUGE_VAL;

    for (int q = 0; q < c->n_pairs; q++)
        first = fmin(first, pair_closes(b, c->owner[q], c->partner[q]));
    for (int q = c->n_pairs; q < c->n_pairs + c->n_walls; q++)
        first = fmin(first, wall_closes(b, c->owner[q], c->partner[q]));
    if (nb->surfaces != NULL) {
        const struct near_faces *const close = &nb->surfaces->chunk[s].close;
        for (int o = 0; o < close->n_owners; o++)
            for (int f = close->owner[o].first; f < close->owner[o].last; f++)
                first = fmin(first, face_closes(nb->surfaces, s, b,
                                                close->owner[o].owner,
                                                &close->face[f]));
    }
    return first;
}

/* The length of the next step [s] after one of `done` [s] that was to be of
 * `next`. */
static double adaptive_next(const struct adaptive *a,
                            const struct dem_options *o,
                            const struct neighbours *nb, double done,
                            double next)
{
    const double V = fmax(neighbours_speed(nb), a->fall);
    double changed = 0.0;

    for (int s = 0; s < nb->n_chunks; s++)
        changed = fmax(changed, a->changed[s]);
    const double error = V > 0.0 ? changed / V : 0.0;
    const double factor =
        error > 0.0 ? fmin(2.0, fmax(0.2, 0.9 * sqrt(o->step_error / error)))
                    : 2.0;
    /* one that was cut short for the list's sake says nothing against `next` */
    const double to = factor < 1.0 ? done * factor : fmax(next, done * factor);
    return fmax(o->shortest_step, fmin(o->step, to));
}

/* --- the step ------------------------------------------------------------- */

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

/* Largest change of a velocity, of v or of R omega, by the second half [m/s].
 */
static double heun_changed(const struct heun *h, const struct chunk *s,
                           const struct rows *b, double dt)
{
    double most = 0.0;

    for (int i = s->begin; i < s->end; i++) {
        const struct row_load *const first = &h->load[i];
        const struct row_load *const second = &s->load[i - s->begin];
        const double per_m = 0.5 * dt * b->motion[i].per_m;
        double F[3], turn[3];
        vector_between(second->F, first->F, F);
        vector_between(second->turn, first->turn, turn);
        most = fmax(most, per_m * vector_length(F));
        most = fmax(most, 2.5 * per_m * vector_length(turn));
    }
    return most;
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

static void heun_correct_all(struct dem *dem, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    for (int s = mine.first; s < mine.last; s++) {
        struct chunk *const own = &nb->chunks[s];
        if (dem->energy != NULL) count_heun(dem, s, dt);
        if (dem->options.integrator->adapts)
            fast_of(dem)->adaptive.changed[s] =
                heun_changed(&fast_of(dem)->heun, own, nb->rows, dt);
        heun_correct(&fast_of(dem)->heun, own, nb->rows, dt);
    }
}

/* Computes a(x, v) without changing the tangential displacements, and stores
 * it. */
static void force_at_start(struct dem *dem, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct chunk_range mine = neighbours_static_range(nb);

    fast_move_loads(dem, 0.0);
    for (int s = mine.first; s < mine.last; s++) {
        heun_save_start(&fast_of(dem)->heun, &nb->chunks[s], nb->rows);
        if (dem->energy != NULL && nb->surfaces != NULL)
            surface_contacts_count(&nb->surfaces->chunk[s], 0.5 * dt);
    }
    neighbours_barrier(nb);
}

/* Prescribed particles have the mean velocity of the step in both of Heun's
 * halves, and so end at the prescribed position; dt = 0: the velocity of that
 * time. */
static void heun_set_prescribed(struct dem *dem, double t, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    if (nb->prescribed == NULL || !dem->motion_on) return;
    fast_move_prescribed(nb, t, dt);
    neighbours_barrier(nb);
}

/* By how much a gap may become smaller in a time of dt [m]. */
static double closing(const struct dem *dem, double dt)
{
    const struct fast *const fast = fast_of(dem);
    const double v = neighbours_speed(fast->neighbours);

    return 2.0 * (v * dt + 0.5 * fast->adaptive.pull * dt * dt);
}

/* When the first gap closes [s]. */
static double until_contact(struct dem *dem)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    struct adaptive *const a = &fast_of(dem)->adaptive;
    const struct chunk_range mine = neighbours_static_range(nb);
    double first = HUGE_VAL;

    for (int s = mine.first; s < mine.last; s++)
        a->closes[s] = adaptive_look(nb, s);
    neighbours_barrier(nb);
    for (int s = 0; s < nb->n_chunks; s++)
        first = fmin(first, a->closes[s]);
    return first;
}

/* Chooses the contacts for a step, and its length of at most `left` [s]; 0: the
 * run ends here. */
static double heun_begin(struct dem *dem, double left, struct contact_margin *r)
{
    const struct fast *const fast = fast_of(dem);
    const struct neighbours *const nb = fast->neighbours;
    const int adapts = dem->options.integrator->adapts;
    double dt = left;

    if (adapts) dt = adaptive_longest(&fast->adaptive, nb, fmin(left, r->next));
    const double closer = closing(dem, dt);
    if (fast_move_crossed(dem, closer)) return 0.0;
    if (r->used + closer > r->margin) fast_move_choose(dem, r, closer);
    if (r->margin < 0.0) return 0.0;
    if (!adapts) return dt;
    const double closes = until_contact(dem);
    const double least = dem->options.shortest_step;
    r->cut = closes <= dt + least;
    return fmin(dt, fmax(least, closes - 0.5 * least));
}

/* Heun's method. The tangential displacements advance by half a step with the
 * slip at the start, for which the contacts are computed once more, and by half
 * a step with the slip at x*, v*. The lists contain the pairs that are near at
 * the start. The contact forces at the end of a run are those at x*, v*,
 * because computing them again would reduce sliding springs once more. */
static void heun_step(struct dem *dem, double from, double to, double dt)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;

    heun_set_prescribed(dem, from, dt);
    fast_move_follow_loads(dem, from);
    force_at_start(dem, dt);
    fast_move_loads(dem, 0.5 * dt);
    predict(dem, dt);
    neighbours_barrier(nb);
    fast_move_surfaces(nb, to);
    fast_move_loads(dem, 0.5 * dt);
    heun_correct_all(dem, dt);
    neighbours_barrier(nb);
}

/* One step of the options, in parts if it adapts. Non-zero if the run ends. */
static int heun_whole_step(struct dem *dem, int k, struct contact_margin *r)
{
    const struct dem_options *const o = &dem->options;
    const struct fast *const fast = fast_of(dem);
    const double end = fast_move_time(dem, k + 1);
    double left = o->step;

    while (left > 0.0) {
        const double dt = heun_begin(dem, left, r);
        if (dt == 0.0) return 1;
        const double closer = closing(dem, dt);
        const int last = dt >= left, on = dem->motion_on;
        heun_step(dem, on ? end - left : end,
                  last || !on ? end : end - left + dt, dt);
        r->used += fmax(closer, closing(dem, dt));
        if (o->integrator->adapts)
            r->next = r->cut ? o->shortest_step
                             : adaptive_next(&fast->adaptive, o,
                                             fast->neighbours, dt, r->next);
        r->parts++;
        left = last ? 0.0 : left - dt;
    }
    return 0;
}

int heun_steps(struct dem *dem, int steps, struct contact_margin *r)
{
    struct neighbours *const nb = fast_of(dem)->neighbours;
    const struct step_parameters still =
        fast_move_parameters(dem, 0.0, 0.0, 0.0);

    if (dem->options.integrator->adapts && omp_get_thread_num() == 0)
        adaptive_begin(&fast_of(dem)->adaptive, nb->rows);
    chunk_step_move(nb, &still); /* for the speeds */
    for (int k = 0; k < steps; k++) {
        if (heun_whole_step(dem, k, r) != 0) return k;
        if (fast_move_interrupted(dem, k)) return k + 1;
    }
    heun_set_prescribed(dem, fast_move_time(dem, steps), 0.0);
    return steps;
}
