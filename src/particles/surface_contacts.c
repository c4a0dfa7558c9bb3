/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/surface_contacts.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

/* Cosine of the angle by which n may turn in a step and be the same [-]. */
static const double same = 0.9;

/* The contact loop writes whole blocks (sweep_buffers.h). */
enum { SPARE = 64 };

void surface_contacts_init(struct surface_contacts *c,
                           const struct surface_scene *scene)
{
    const size_t n = (size_t)scene->n;

    memset(c, 0, sizeof *c);
    c->pose = alloc_zeroed(n, sizeof *c->pose);
    c->built = alloc_zeroed(n, sizeof *c->built);
    c->account = alloc_zeroed(n, sizeof *c->account);
    for (int s = 0; s < scene->n; s++)
        c->pose[s] = motion_pose(&scene->surface[s].motion, 0.0);
}

/* The arrays of the loop, which hold nothing from step to step. */
static void free_arrays(struct surface_contacts *c)
{
    free(c->place);
    free(c->motion);
    free(c->material);
    strip_release(&c->pairs);
}

void surface_contacts_release(struct surface_contacts *c)
{
    near_faces_release(&c->vicinity);
    near_faces_release(&c->close);
    free(c->touches.list);
    free(c->now.list);
    free(c->before.list);
    free(c->kept.list);
    free_arrays(c);
    free(c->pose);
    free(c->built);
    free(c->account);
}

void surface_contacts_remember(struct footprints *f,
                               const struct footprint *one)
{
    f->list = near_faces_room(f->list, f->n, &f->room, sizeof *f->list);
    f->list[f->n++] = *one;
}

void surface_contacts_sort(struct footprints *f)
{
    for (int q = 1; q < f->n; q++) {
        const struct footprint one = f->list[q];
        int at = q;
        for (; at > 0 && f->list[at - 1].owner > one.owner; at--)
            f->list[at] = f->list[at - 1];
        f->list[at] = one;
    }
}

static void make_room(struct surface_contacts *c, int n, int rolls)
{
    struct contacts *const k = &c->pairs.contacts;
    const double deepest = c->pairs.deepest;
    const struct strip_energy energy = c->pairs.energy;

    if (n <= c->room) return;
    c->room = n + n / 2 + 64;
    free_arrays(c);
    c->place = alloc_zeroed(2 * (size_t)c->room, 4 * sizeof(double));
    c->motion = alloc_zeroed(2 * (size_t)c->room, 8 * sizeof(double));
    memset(&c->pairs, 0, sizeof c->pairs);
    c->pairs.deepest = deepest;
    c->pairs.energy = energy;
    c->pairs.rolls = rolls;
    c->material = alloc_ints(2 * c->room);
    c->pairs.load = alloc_zeroed(2 * (size_t)c->room, 8 * sizeof(double));
    k->capacity = c->room + SPARE;
    k->owner = alloc_ints(k->capacity);
    k->partner = alloc_ints(k->capacity);
    for (int a = 0; a < 3; a++)
        k->spring[a] = alloc_doubles(k->capacity);
    for (int a = 0; rolls && a < 3; a++)
        k->roll[a] = alloc_doubles(k->capacity);
}

/* The particle is at the origin, the sphere behind the surface r + R from it
 * along -n: their overlap is 2 R - (r + R) = R - r, at any r > -R. */
static void put_spheres(struct surface_contacts *c,
                        const struct surface_scene *scene, int q,
                        const struct bodies *b)
{
    const struct touch *const t = &c->touches.list[q];
    double *const mine = c->place[2 * q];
    double *const mirror = c->place[2 * q + 1];
    double *const moves = c->motion[2 * q + 1];
    const double R = b->place[t->owner][3];

    for (int k = 0; k < 3; k++) {
        mine[k] = 0.0;
        mirror[k] = -(t->r + R) * t->n[k];
    }
    mine[3] = mirror[3] = R;
    memcpy(c->motion[2 * q], b->motion[t->owner], 8 * sizeof(double));
    memset(moves, 0, 8 * sizeof(double));
    memcpy(moves, t->v, sizeof t->v);
    c->material[2 * q] = b->material != NULL ? b->material[t->owner] : 0;
    c->material[2 * q + 1] = scene->surface[t->surface].material;
    c->pairs.contacts.owner[q] = 2 * q;
    c->pairs.contacts.partner[q] = 2 * q + 1;
}

/* The footprint of this contact in the step before, if there is one; it is used
 * up. *at moves on with the owner. */
static void put_spring(struct surface_contacts *c, int q, int *at)
{
    struct contacts *const k = &c->pairs.contacts;
    const struct touch *const t = &c->touches.list[q];
    struct footprints *const old = &c->before;
    struct footprint *found = NULL;
    double best = same;

    while (*at < old->n && old->list[*at].owner < t->owner)
        ++*at;
    for (int p = *at; p < old->n && old->list[p].owner == t->owner; p++) {
        const double turned = vector_dot(old->list[p].n, t->n);
        if (turned > best) {
            best = turned;
            found = &old->list[p];
        }
    }
    for (int a = 0; a < 3; a++) {
        k->spring[a][q] = found != NULL ? found->xi[a] : 0.0;
        if (c->pairs.rolls)
            k->roll[a][q] = found != NULL ? found->roll[a] : 0.0;
        if (found != NULL) found->n[a] = 0.0;
    }
}

/* Loads to the particles, what they are to the surface to its account. */
static void settle(struct surface_contacts *c, int q, struct strip *s,
                   const struct pose *pose, double dt)
{
    const struct touch *const t = &c->touches.list[q];
    const double *const load = c->pairs.load[2 * q];
    double *const sum = s->load[t->owner - s->begin];
    double *const impulse = c->account[t->surface].impulse;
    double *const angular = c->account[t->surface].angular;
    double arm[3], torque[3];

    for (int k = 0; k < 8; k++)
        sum[k] += load[k];
    vector_between(t->q, pose[t->surface].centre, arm);
    vector_cross(arm, load, torque);
    for (int k = 0; k < 3; k++) {
        impulse[k] -= dt * load[k];
        angular[k] -= dt * torque[k];
    }
    c->account[t->surface].work += dt * vector_dot(load, t->v);
}

static void leave_footprint(struct surface_contacts *c, int q)
{
    const struct touch *const t = &c->touches.list[q];
    struct footprint one = {.owner = t->owner};

    for (int k = 0; k < 3; k++) {
        one.n[k] = t->n[k];
        one.xi[k] = c->pairs.contacts.spring[k][q];
        if (c->pairs.rolls) one.roll[k] = c->pairs.contacts.roll[k][q];
    }
    surface_contacts_remember(&c->now, &one);
}

/* As strip_look_deep does it. */
static void look_deep(const struct surface_contacts *c, struct strip *s,
                      const struct bodies *b)
{
    for (int q = 0; q < c->touches.n; q++) {
        const struct touch *const t = &c->touches.list[q];
        const double *const x = b->place[t->owner];
        strip_note(&s->deep, 0.5 * (1.0 - t->r / x[3]), b->id[t->owner],
                   -7 - t->surface, x);
    }
    if (c->pairs.deepest > s->deep.overlap) s->deep.overlap = c->pairs.deepest;
}

void surface_contacts_push(struct surface_contacts *c,
                           const struct surface_scene *scene, struct strip *s,
                           const struct bodies *b, contact_sweep *sweep,
                           const struct contact_constants *k, double dt)
{
    const struct footprints old = c->before;
    struct bodies two = *b;
    int at = 0;

    touches_find(&c->touches, &c->close, scene, c->pose, b);
    const int n = c->touches.n;
    make_room(c, n, s->rolls);
    c->before = c->now;
    c->now = old;
    c->now.n = 0;
    for (int q = 0; q < n; q++) {
        put_spheres(c, scene, q, b);
        put_spring(c, q, &at);
    }
    c->pairs.contacts.n_pairs = n;
    c->pairs.window = c->pairs.end = two.n = 2 * n;
    two.place = c->place;
    two.motion = c->motion;
    two.material = c->material;
    strip_open_budget(&c->pairs.energy);
    if (n > 0) {
        memset(c->pairs.load, 0, 2 * (size_t)n * sizeof *c->pairs.load);
        sweep(&c->pairs, &two, k, dt, 0, n);
    }
    strip_close_budget(&c->pairs.energy);
    if (c->pairs.deepest > s->deep.overlap) look_deep(c, s, b);
    for (int q = 0; q < n; q++) {
        settle(c, q, s, c->pose, dt);
        leave_footprint(c, q);
    }
}
