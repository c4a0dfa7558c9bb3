/* SPDX-License-Identifier: GPL-3.0-or-later */
/* adaptive.c -- the length of a step of Heun's method that adapts.
 * Chapter "Insertion, removal and energy".
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

#include "base/alloc.h"
#include "base/vector.h"

struct adaptive adaptive_create(void *owner, const struct dem_options *o,
                                int n_chunks)
{
    const size_t n = (size_t)n_chunks;
    struct adaptive a = {.next = o->shortest_step};

    a.changed = owner_zeroed(owner, n, sizeof *a.changed);
    a.closes = owner_zeroed(owner, n, sizeof *a.closes);
    return a;
}

void adaptive_begin(struct adaptive *a, const struct rows *b)
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
 * closer by an eighth of the skin: half of what the contacts are chosen for. */
double adaptive_longest(const struct adaptive *a, const struct neighbours *nb,
                        double speed, double length)
{
    const double way = nb->skin / 16.0;
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

void adaptive_look(struct adaptive *a, const struct neighbours *nb, int s)
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
    a->closes[s] = first;
}

double adaptive_closes(const struct adaptive *a, int n_chunks)
{
    double first = HUGE_VAL;

    for (int s = 0; s < n_chunks; s++)
        first = fmin(first, a->closes[s]);
    return first;
}

double adaptive_next(const struct adaptive *a, const struct dem_options *o,
                     const struct neighbours *nb, double done, double next)
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
