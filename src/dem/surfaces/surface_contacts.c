/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface_contacts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/fast/sweep.h"

/* Cosine of the angle by which n may turn in a step and be the same [-]. */
static const double same = 0.9;

void surface_contacts_init(struct surface_contacts *c, void *owner,
                           const struct surface_scene *scene)
{
    const size_t n = (size_t)scene->n;

    memset(c, 0, sizeof *c);
    c->pose = owner_zeroed(owner, n, sizeof *c->pose);
    c->built = owner_zeroed(owner, n, sizeof *c->built);
    c->received = owner_zeroed(owner, n, sizeof *c->received);
    for (int s = 0; s < scene->n; s++)
        c->pose[s] = motion_pose(&scene->surface[s].motion, 0.0);
}

void surface_contacts_release(struct surface_contacts *c)
{
    near_faces_release(&c->list);
    near_faces_release(&c->close);
    free(c->touches.list);
    free(c->current.list);
    free(c->previous.list);
    free(c->saved.list);
    free(c->place);
    free(c->motion);
    free(c->ball);
    free(c->material);
    chunk_release(&c->pairs);
}

void surface_contacts_save(struct surface_histories *f,
                           const struct surface_history *one)
{
    f->list = alloc_room(f->list, f->n, &f->capacity, sizeof *f->list);
    f->list[f->n++] = *one;
}

void surface_contacts_sort(struct surface_histories *f)
{
    for (int q = 1; q < f->n; q++) {
        const struct surface_history one = f->list[q];
        int at = q;
        for (; at > 0 && f->list[at - 1].owner > one.owner; at--)
            f->list[at] = f->list[at - 1];
        f->list[at] = one;
    }
}

/* The arrays of the loop hold nothing from step to step. */
static void surface_contacts_make_room(struct surface_contacts *c, int n,
                                       int rolls, int budget)
{
    c->pairs.has_rolling = rolls;
    c->pairs.has_budget = budget;
    chunk_reserve_contacts(&c->pairs, n, 0);
    chunk_reserve_loads(&c->pairs, 2 * (size_t)n * sizeof *c->pairs.load, 0);
    if (n <= c->capacity) return;
    c->capacity = n + n / 2 + 64;
    c->place = alloc_grown(c->place, 0, 2 * c->capacity, sizeof *c->place);
    c->motion = alloc_grown(c->motion, 0, 2 * c->capacity, sizeof *c->motion);
    c->ball = alloc_grown(c->ball, 0, 2 * c->capacity, sizeof *c->ball);
    c->material =
        alloc_grown(c->material, 0, 2 * c->capacity, sizeof *c->material);
}

/* The particle is at the origin, the sphere behind the surface r + R from it
 * along -n: their overlap is 2 R - (r + R) = R - r, at any r > -R. */
static void surface_contacts_put_spheres(struct surface_contacts *c,
                                         const struct surface_scene *scene,
                                         int q, const struct rows *b)
{
    const struct surface_contact_point *const t = &c->touches.list[q];
    const double R = b->place[t->owner].R, behind = -(t->r + R);

    c->place[2 * q] = (struct row_place){{0.0, 0.0, 0.0}, R};
    c->place[2 * q + 1] = (struct row_place){
        {behind * t->n[0], behind * t->n[1], behind * t->n[2]}, R};
    c->motion[2 * q] = b->motion[t->owner];
    if (b->own_inverse_mass != NULL && b->own_inverse_mass[t->owner] > 0.0)
        c->motion[2 * q].per_m = b->own_inverse_mass[t->owner];
    c->motion[2 * q + 1] =
        (struct row_motion){.v = {t->v[0], t->v[1], t->v[2]}};
    if (b->ball != NULL) {
        c->ball[2 * q] = b->ball[t->owner];
        c->ball[2 * q + 1].of = -1;
    }
    c->material[2 * q] = b->material != NULL ? b->material[t->owner] : 0;
    c->material[2 * q + 1] = scene->surface[t->surface].material;
    c->pairs.contacts.owner[q] = 2 * q;
    c->pairs.contacts.partner[q] = 2 * q + 1;
}

/* Returns the history of this contact from the previous step, if there is one,
 * and marks it as used. *at advances with the owner. */
static void put_spring(struct surface_contacts *c, int q, int *at)
{
    struct chunk_contacts *const k = &c->pairs.contacts;
    struct surface_contact_point *const t = &c->touches.list[q];
    struct surface_histories *const old = &c->previous;
    struct surface_history *found = NULL;
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
    t->before = found != NULL ? (int)(found - old->list) : -1;
    for (int a = 0; a < 3; a++) {
        k->xi[a][q] = found != NULL ? found->xi[a] : 0.0;
        if (c->pairs.has_rolling)
            k->roll_angle[a][q] = found != NULL ? found->roll_angle[a] : 0.0;
        if (found != NULL) found->n[a] = 0.0;
    }
}

/* Adds the loads to the particles, and their reactions to the totals of the
 * surface. */
static void accumulate_load(struct surface_contacts *c, int q, struct chunk *s,
                            const struct pose *pose, double dt)
{
    const struct surface_contact_point *const t = &c->touches.list[q];
    const struct row_load *const one = &c->pairs.load[2 * q];
    const double *const load = one->F;
    double *const impulse = c->received[t->surface].impulse;
    double *const angular = c->received[t->surface].angular;
    double arm[3], torque[3];

    row_load_add(&s->load[t->owner - s->begin], one);
    vector_between(t->q, pose[t->surface].centre, arm);
    vector_cross(arm, load, torque);
    for (int k = 0; k < 3; k++) {
        impulse[k] -= dt * load[k];
        angular[k] -= dt * torque[k];
        c->received[t->surface].force[k] -= load[k];
        c->received[t->surface].torque[k] -= torque[k];
    }
    c->received[t->surface].work += dt * vector_dot(load, t->v);
}

/* Adds the parts that the budget counts, and the power of the surface. */
static void accumulate_parts(struct surface_contacts *c, int q, struct chunk *s)
{
    const struct surface_contact_point *const t = &c->touches.list[q];
    struct row_load *const to = s->part[t->owner - s->begin];

    c->power[ENERGY_PARTS] += vector_dot(c->pairs.load[2 * q].F, t->v);
    for (int a = 0; a < ENERGY_PARTS; a++) {
        const struct row_load *const part = &c->pairs.part[2 * q][a];
        c->power[a] += vector_dot(part->F, t->v);
        row_load_add(&to[a], part);
    }
}

void surface_contacts_count(struct surface_contacts *c, double t)
{
    struct chunk_energy *const e = &c->pairs.energy;

    e->prescribed += t * c->power[ENERGY_PARTS];
    e->damped_n += t * c->power[ENERGY_DASHPOTS];
    e->damped_t += t * c->power[ENERGY_DASHPOTS_T];
    e->released += t * c->power[ENERGY_FRICTION];
}

/* What a contact with a surface under load resists its motion with, from the
 * law. */
static void add_resistance(struct surface_contacts *c, int q,
                           const struct rows *b,
                           const struct contact_constants *k)
{
    const struct surface_contact_point *const t = &c->touches.list[q];
    struct surface_received *const to = &c->received[t->surface];
    const int pair = c->material[2 * q] * b->n_materials;
    const struct contact_constants *const of =
        &k[pair + c->material[2 * q + 1]];
    const double R = b->place[t->owner].R, delta = R - t->r, more = 1e-6 * R;
    const double m = 1.0 / c->motion[2 * q].per_m;
    const struct contact_response now = b->law->respond(of, delta, R, m);
    const double F = b->law->respond(of, delta + more, R, m).elastic;

    to->impedance += sqrt(m * (F - now.elastic) / more);
    to->damping += now.eta_n;
}

/* What the contact has worn off in this step. */
static void count_wear(struct surface_contacts *c,
                       const struct surface_scene *scene, int q,
                       const struct rows *b, double dt)
{
    struct surface_contact_point *const t = &c->touches.list[q];
    const struct wear_of *const of = &scene->surface[t->surface].wear;
    const struct row_motion *const m = &c->motion[2 * q];
    const double R = b->place[t->owner].R;
    double v[3];

    t->F_n = vector_dot(c->pairs.load[2 * q].F, t->n);
    if (!(of->hardness > 0.0)) return;
    vector_between(m->v, t->v, v);
    if (t->before < 0 && m->per_m > 0.0)
        t->worn = wear_finnie(of, 1.0 / m->per_m, v, t->n);
    if (of->archard == 0.0 || dt == 0.0) return;

    const struct surface_history none = {0};
    const struct surface_history *const old =
        t->before < 0 ? &none : &c->previous.list[t->before];
    double slip[3], around[3];
    vector_cross(m->s, t->n, around); /* s is R omega */
    for (int k = 0; k < 3; k++)
        slip[k] = old->xi[k] - c->pairs.contacts.xi[k][q] +
                  dt * (v[k] - 0.5 * (t->r + R) / R * around[k]);
    vector_along(slip, -vector_dot(slip, t->n), t->n, slip);
    t->worn += wear_archard(of, 0.5 * (old->F_n + t->F_n), vector_length(slip));
}

static void save_contact(struct surface_contacts *c, int q)
{
    const struct surface_contact_point *const t = &c->touches.list[q];
    struct surface_history one = {.owner = t->owner};

    for (int k = 0; k < 3; k++) {
        one.n[k] = t->n[k];
        one.xi[k] = c->pairs.contacts.xi[k][q];
        if (c->pairs.has_rolling)
            one.roll_angle[k] = c->pairs.contacts.roll_angle[k][q];
    }
    one.F_n = t->F_n;
    surface_contacts_save(&c->current, &one);
}

/* As chunk_check_overlaps does it. */
static void measure_overlaps(const struct surface_contacts *c, struct chunk *s,
                             const struct rows *b)
{
    for (int q = 0; q < c->touches.n; q++) {
        const struct surface_contact_point *const t = &c->touches.list[q];
        const struct row_place *const at = &b->place[t->owner];
        chunk_record_overlap(&s->deep, 0.5 * (1.0 - t->r / at->R),
                             b->id[t->owner], -7 - t->surface, at->x);
    }
    if (c->pairs.max_overlap > s->deep.depth)
        s->deep.depth = c->pairs.max_overlap;
}

void surface_contacts_add_loads(struct surface_contacts *c,
                                const struct surface_scene *scene,
                                struct chunk *s, const struct rows *b,
                                const struct contact_constants *k, double dt)
{
    const struct surface_histories old = c->previous;
    struct rows two = *b;
    int at = 0;

    surface_contact_points_find(&c->touches, &c->close, scene, c->pose, b);
    const int n = c->touches.n;
    surface_contacts_make_room(c, n, s->has_rolling, s->has_budget);
    memset(c->power, 0, sizeof c->power);
    c->previous = c->current;
    c->current = old;
    c->current.n = 0;
    for (int q = 0; q < n; q++) {
        surface_contacts_put_spheres(c, scene, q, b);
        put_spring(c, q, &at);
    }
    c->pairs.contacts.n_pairs = n;
    c->pairs.window = c->pairs.end = two.n = 2 * n;
    two.place = c->place;
    two.motion = c->motion;
    two.material = c->material;
    if (b->ball != NULL) two.ball = c->ball;
    two.own_inverse_mass = NULL; /* put_spheres has used it */
    for (int a = 0; a < scene->n; a++) {
        memset(c->received[a].force, 0, sizeof c->received[a].force);
        memset(c->received[a].torque, 0, sizeof c->received[a].torque);
        c->received[a].impedance = c->received[a].damping = 0.0;
    }
    chunk_begin_budget(&c->pairs.energy);
    if (n > 0) {
        memset(c->pairs.load, 0, 2 * (size_t)n * sizeof *c->pairs.load);
        if (s->has_budget)
            memset(c->pairs.part, 0, 2 * (size_t)n * sizeof *c->pairs.part);
        sweep_contacts(&c->pairs, &two, k, dt, 0, n);
    }
    chunk_end_budget(&c->pairs.energy);
    if (c->pairs.max_overlap > s->deep.depth) measure_overlaps(c, s, b);
    for (int q = 0; q < n; q++) {
        accumulate_load(c, q, s, c->pose, dt);
        if (s->has_budget) accumulate_parts(c, q, s);
        if (scene->wears) count_wear(c, scene, q, b, dt);
        if (scene->loaded) add_resistance(c, q, b, k);
        save_contact(c, q);
    }
}

void surface_contacts_push(struct surface_contacts *c,
                           const struct surface_scene *scene, double t)
{
    for (int a = 0; a < scene->n; a++) {
        struct surface_received *const r = &c->received[a];
        if (scene->surface[a].motion.carrier == NULL) continue;
        for (int k = 0; k < 3; k++) {
            r->impulse[k] += t * r->force[k];
            r->angular[k] += t * r->torque[k];
        }
    }
}
