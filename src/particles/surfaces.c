/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "particles/triangle.h"

struct surfaces *surfaces_create(const struct surface *list, int n,
                                 const struct domain *box, int count)
{
    struct surfaces *const sf = alloc_zeroed(1, sizeof *sf);

    sf->scene = (struct surface_scene){list, n, box};
    sf->count = count;
    sf->strip = alloc_zeroed((size_t)count, sizeof *sf->strip);
    for (int s = 0; s < count; s++)
        surface_contacts_init(&sf->strip[s], &sf->scene);
    for (int k = 0; k < n; k++) {
        const double reach = surface_reach(&list[k], box->lo, box->hi);
        sf->speed = fmax(sf->speed, motion_speed(&list[k].motion, reach));
    }
    return sf;
}

void surfaces_free(struct surfaces *sf)
{
    if (sf == NULL) return;
    for (int s = 0; s < sf->count; s++)
        surface_contacts_release(&sf->strip[s]);
    free(sf->strip);
    free(sf->where);
    free(sf);
}

void surfaces_move(struct surfaces *sf, int s, double t)
{
    struct surface_contacts *const c = &sf->strip[s];

    if (t == c->time) return;
    c->time = t;
    for (int k = 0; k < sf->scene.n; k++)
        if (motion_is_any(&sf->scene.surface[k].motion))
            c->pose[k] = motion_pose(&sf->scene.surface[k].motion, t);
}

double surfaces_moved(const struct surfaces *sf, int s)
{
    const struct surface_contacts *const c = &sf->strip[s];
    return sf->speed * fabs(c->time - c->built_time);
}

void surfaces_keep(struct surfaces *sf, int s, const struct particles *ps)
{
    struct surface_contacts *const c = &sf->strip[s];

    c->kept.n = 0;
    for (int q = 0; q < c->now.n; q++) {
        struct footprint one = c->now.list[q];
        one.id = ps->id[one.owner];
        surface_contacts_remember(&c->kept, &one);
    }
}

void surfaces_index(struct surfaces *sf, const struct particles *ps)
{
    int highest = -1;

    for (int i = 0; i < ps->n; i++)
        highest = ps->id[i] > highest ? ps->id[i] : highest;
    if (highest >= sf->ids) {
        free(sf->where);
        sf->ids = highest + highest / 2 + 1;
        sf->where = alloc_ints(sf->ids);
    }
    for (int id = 0; id < sf->ids; id++)
        sf->where[id] = -1;
    for (int i = 0; i < ps->n; i++)
        sf->where[ps->id[i]] = i;
}

/* The springs of this strip's particles, whoever kept them. */
static void restore(struct surfaces *sf, int s, const struct strip *strip)
{
    struct footprints *const now = &sf->strip[s].now;

    now->n = 0;
    for (int t = 0; t < sf->count; t++) {
        const struct footprints *const kept = &sf->strip[t].kept;
        for (int q = 0; q < kept->n; q++) {
            struct footprint one = kept->list[q];
            one.owner = one.id < sf->ids ? sf->where[one.id] : -1;
            if (one.owner >= strip->begin && one.owner < strip->end)
                surface_contacts_remember(now, &one);
        }
    }
    surface_contacts_sort(now);
}

void surfaces_find(struct surfaces *sf, int s, const struct strip *strip,
                   const struct bodies *b, double skin)
{
    struct surface_contacts *const c = &sf->strip[s];

    restore(sf, s, strip);
    near_faces_find(&c->vicinity, &sf->scene, c->pose, strip, b, skin);
    memcpy(c->built, c->pose, (size_t)sf->scene.n * sizeof *c->built);
    c->built_time = c->time;
}

void surfaces_choose(struct surfaces *sf, int s, const struct bodies *b,
                     double margin)
{
    struct surface_contacts *const c = &sf->strip[s];
    near_faces_choose(&c->close, &c->vicinity, &sf->scene, c->pose, b, margin);
}

void surfaces_push(struct surfaces *sf, int s, struct strip *strip,
                   const struct bodies *b, contact_sweep *sweep,
                   const struct contact_constants *k, double dt)
{
    surface_contacts_push(&sf->strip[s], &sf->scene, strip, b, sweep, k, dt);
}

/* The way of particle i since the lists were made, as the surface sees it. */
static int crosses(const struct surface_contacts *c,
                   const struct surface_scene *scene, int surface, int face,
                   const double shift[3], const struct bodies *b, int i)
{
    const struct near_face at = {surface, face, {shift[0], shift[1], shift[2]}};
    double x[3], old[3], from[3], to[3];

    vector_along(b->mark[i], 1.0, shift, old);
    near_faces_image(&at, b, i, x);
    motion_origin(&c->built[surface], old, from);
    motion_origin(&c->pose[surface], x, to);
    return triangle_crossed(
        (const double(*)[3])scene->surface[surface].triangles->corner[face],
        from, to);
}

/* Somebody so fast that the lists know nothing of his way: all triangles. */
static int jumps_through(const struct surface_contacts *c,
                         const struct surface_scene *scene, int surface,
                         const struct bodies *b, int i)
{
    static const double here[3] = {0.0, 0.0, 0.0};

    if (scene->surface[surface].shape != SURFACE_TRIANGLES) return 0;
    for (int f = 0; f < scene->surface[surface].triangles->n; f++)
        if (crosses(c, scene, surface, f, here, b, i)) return 1;
    return 0;
}

static double moved2(const struct bodies *b, int i)
{
    const struct near_face none = {0};
    double x[3], way[3];

    near_faces_image(&none, b, i, x);
    vector_between(x, b->mark[i], way);
    return vector_dot(way, way);
}

static void note(struct bodies_survey *found, int i, int surface)
{
    if (found->lost++ > 0) return;
    found->first = i;
    found->through = surface;
}

/* The surface that particle i is deep in, or leapt through; or -1. */
static int beyond(const struct surface_contacts *c,
                  const struct surface_scene *scene, const struct bodies *b,
                  int i, int fast)
{
    for (int k = 0; k < scene->n; k++)
        if (surface_holds(&scene->surface[k], &c->pose[k], b->place[i],
                          b->place[i][3]) ||
            (fast && jumps_through(c, scene, k, b, i)))
            return k;
    return -1;
}

/* The surface near an owner that it has crossed, or -1. */
static int crossed(const struct surface_contacts *c,
                   const struct surface_scene *scene, const struct bodies *b,
                   const struct near_owner *own)
{
    for (int f = own->first; f < own->last; f++) {
        const struct near_face *const face = &c->vicinity.face[f];
        if (scene->surface[face->surface].shape == SURFACE_TRIANGLES &&
            crosses(c, scene, face->surface, face->face, face->shift, b,
                    own->owner))
            return face->surface;
    }
    return -1;
}

void surfaces_look(const struct surfaces *sf, int s, const struct strip *strip,
                   const struct bodies *b, int marks, double skin,
                   struct bodies_survey *found)
{
    const struct surface_contacts *const c = &sf->strip[s];

    if (found->lost > 0) return;
    for (int i = strip->begin; i < strip->end; i++) {
        const int fast = marks && moved2(b, i) > skin * skin;
        const int surface = beyond(c, &sf->scene, b, i, fast);
        if (surface >= 0) note(found, i, surface);
    }
    if (!marks || found->lost > 0) return;
    for (int o = 0; o < c->vicinity.n_owners; o++) {
        const struct near_owner *const own = &c->vicinity.owner[o];
        const int surface = crossed(c, &sf->scene, b, own);
        if (surface >= 0) note(found, own->owner, surface);
    }
}

const struct footprints *surfaces_springs(struct surfaces *sf, int s,
                                          const struct particles *ps)
{
    if (ps != NULL) surfaces_keep(sf, s, ps);
    return &sf->strip[s].kept;
}

void surfaces_forget(struct surfaces *sf)
{
    for (int s = 0; s < sf->count; s++)
        sf->strip[s].kept.n = sf->strip[s].now.n = 0;
}

void surfaces_recall(struct surfaces *sf, const struct footprint *one)
{
    surface_contacts_remember(&sf->strip[0].kept, one);
}

void surfaces_open(struct surfaces *sf)
{
    for (int s = 0; s < sf->count; s++)
        sf->strip[s].pairs.deepest = 0.0;
}

int surfaces_contacts(const struct surfaces *sf)
{
    int n = 0;

    for (int s = 0; s < sf->count; s++)
        n += sf->strip[s].touches.n;
    return n;
}

double surfaces_deepest(const struct surfaces *sf)
{
    double deepest = 0.0;

    for (int s = 0; s < sf->count; s++)
        deepest = fmax(deepest, sf->strip[s].pairs.deepest);
    return deepest;
}

struct strip_energy *surfaces_energy(struct surfaces *sf, int s)
{
    return &sf->strip[s].pairs.energy;
}

double surfaces_work(const struct surfaces *sf)
{
    double sum = 0.0;

    for (int s = 0; s < sf->count; s++)
        for (int k = 0; k < sf->scene.n; k++)
            sum += sf->strip[s].account[k].work;
    return sum;
}

struct surface_account surfaces_account(const struct surfaces *sf, int surface)
{
    struct surface_account sum = {.work = 0.0};

    for (int s = 0; s < sf->count; s++) {
        const struct surface_account *const a = &sf->strip[s].account[surface];
        for (int k = 0; k < 3; k++) {
            sum.impulse[k] += a->impulse[k];
            sum.angular[k] += a->angular[k];
        }
        sum.work += a->work;
    }
    return sum;
}
