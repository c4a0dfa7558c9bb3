/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surfaces_state.c -- the visit of the surfaces.  Chapter "Nothing is lost". */
#include "dem/surfaces/surfaces.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "base/alloc.h"
#include "dem/fast/fast.h"
#include "dem/surfaces/surface.h"

/* 1 if each owner has a part of the list, and each face is one of its surface.
 */
static int are_faces(const struct near_faces *l,
                     const struct surface_scene *scene)
{
    for (int o = 0; o < l->n_owners; o++)
        if (l->owner[o].first > l->owner[o].last) return 0;
    for (int f = 0; f < l->n_faces; f++) {
        const struct triangles *const t =
            scene->surface[l->face[f].surface].triangles;
        if (l->face[f].face >= (t != NULL ? t->n : 1)) return 0;
    }
    return 1;
}

/* Visits all faces, under this name (state.h), of the particles of a chunk. */
static void near_faces_state(struct near_faces *l, const char *name,
                             const struct surface_scene *scene,
                             const struct chunk *chunk, struct state *s)
{
    state_begin(s, name);
    state_count(s, "owners", &l->n_owners, INT_MAX);
    state_count(s, "faces", &l->n_faces, INT_MAX);
    if (s->loading && !s->failed) {
        free(l->owner);
        free(l->face);
        l->owner_capacity = l->n_owners;
        l->face_capacity = l->n_faces;
        l->owner = alloc_zeroed((size_t)l->n_owners, sizeof *l->owner);
        l->face = alloc_zeroed((size_t)l->n_faces, sizeof *l->face);
    }
    const size_t owner = sizeof *l->owner, face = sizeof *l->face;
    state_indices_of(s, "owner", &l->owner->owner, owner, l->n_owners,
                     chunk->begin, chunk->end - 1);
    state_indices_of(s, "first", &l->owner->first, owner, l->n_owners, 0,
                     l->n_faces);
    state_indices_of(s, "last", &l->owner->last, owner, l->n_owners, 0,
                     l->n_faces);
    state_indices_of(s, "surface", &l->face->surface, face, l->n_faces, 0,
                     scene->n - 1);
    state_indices_of(s, "face", &l->face->face, face, l->n_faces, 0, INT_MAX);
    if (s->loading && !s->failed)
        state_demand(s, are_faces(l, scene), "a face that is not there");
    state_reals_of(s, "shift", "m", l->face->shift, face, l->n_faces, 3);
    state_end(s);
}

static void surfaces_state_histories(struct surface_histories *f,
                                     const char *name, int capacity, int wears,
                                     struct state *s)
{
    state_begin(s, name);
    state_count(s, "count", &f->n, INT_MAX);
    if (s->loading && !s->failed) {
        free(f->list);
        f->capacity = f->n;
        f->list = alloc_zeroed((size_t)f->n, sizeof *f->list);
    }
    struct surface_history *const all = f->list;
    state_indices_of(s, "owner", &all->owner, sizeof *all, f->n, 0,
                     capacity - 1);
    state_indices_of(s, "id", &all->id, sizeof *all, f->n, 0, INT_MAX);
    state_reals_of(s, "n", "-", all->n, sizeof *all, f->n, 3);
    state_reals_of(s, "xi", "m", all->xi, sizeof *all, f->n, 3);
    state_reals_of(s, "roll_angle", "rad", all->roll_angle, sizeof *all, f->n,
                   3);
    if (wears) state_reals_of(s, "F_n", "N", &all->F_n, sizeof *all, f->n, 1);
    state_end(s);
}

/* The places of the surfaces follow from the time, but for those that others
 * carry. */
static void set_poses(struct surface_contacts *c,
                      const struct surface_scene *scene)
{
    for (int k = 0; k < scene->n; k++) {
        const struct motion *const m = &scene->surface[k].motion;
        c->pose[k] = motion_pose(m, motion_is_any(m) ? c->time : 0.0);
        c->built[k] = motion_pose(m, motion_is_any(m) ? c->built_time : 0.0);
    }
}

static void surfaces_state_contacts(struct surface_contacts *c,
                                    const struct surface_scene *scene,
                                    const struct chunk *chunk, int capacity,
                                    struct state *s)
{
    const int n = scene->n;
    struct surface_received *const all = c->received;

    state_real(s, "time", "s", &c->time);
    state_real(s, "built_time", "s", &c->built_time);
    near_faces_state(&c->list, "list", scene, chunk, s);
    near_faces_state(&c->close, "close", scene, chunk, s);
    surfaces_state_histories(&c->current, "current", capacity, scene->wears, s);
    surfaces_state_histories(&c->saved, "saved", capacity, scene->wears, s);
    state_reals_of(s, "impulse", "N s", all->impulse, sizeof *all, n, 3);
    state_reals_of(s, "angular", "N m s", all->angular, sizeof *all, n, 3);
    state_reals_of(s, "work", "J", &all->work, sizeof *all, n, 1);
    chunk_energy_state(&c->pairs.energy, s);
    state_reals(s, "power", "W", c->power, ENERGY_PARTS + 1, 1);
}

static void carried_state(struct surface_contacts *c, int n, struct state *s)
{
    state_reals_of(s, "centre_at_rebuild", "m", c->built->centre,
                   sizeof *c->built, n, 3);
    state_reals_of(s, "force", "N", c->received->force, sizeof *c->received, n,
                   3);
    state_reals_of(s, "torque", "N m", c->received->torque, sizeof *c->received,
                   n, 3);
}

/* Where those under load are, and what resists them. */
static void load_state(struct surfaces *sf, int k, struct state *s)
{
    struct carrier *const c = sf->scene.surface[k].load.carrier;

    state_begin_number(s, "load", k);
    state_real(s, "t", "s", &c->t);
    state_reals(s, "centre", "m", c->pose.centre, 3, 1);
    state_reals(s, "velocity", "m/s", c->pose.velocity, 3, 1);
    for (int q = 0; q < sf->n_chunks; q++) {
        state_begin_number(s, "chunk", q);
        state_real(s, "impedance", "kg/s", &sf->chunk[q].received[k].impedance);
        state_real(s, "damping", "kg/s", &sf->chunk[q].received[k].damping);
        state_end(s);
    }
    state_end(s);
}

void surfaces_state(struct surfaces *sf, const struct chunk *chunks,
                    int capacity, struct state *s)
{
    state_begin(s, "surfaces");
    for (int k = 0; k < sf->scene.n; k++)
        if (sf->scene.surface[k].load.speed > 0.0) load_state(sf, k, s);
    for (int k = 0; k < sf->n_chunks; k++) {
        struct surface_contacts *const c = &sf->chunk[k];
        state_begin_number(s, "chunk", k);
        surfaces_state_contacts(c, &sf->scene, &chunks[k], capacity, s);
        if (s->loading) set_poses(c, &sf->scene);
        if (sf->carried) carried_state(c, sf->scene.n, s);
        state_end(s);
    }
    if (sf->wear.n > 0) wear_state(sf->wear.face, sf->wear.n, s);
    state_end(s);
}

/* --- surface history ------------------------------------------------------ */

/* `other` of them all: after the walls of the box, -1 to -6. */
enum { SURFACE_SPRING = -7 };

int surface_history_list(struct surfaces *sf, const struct particles *ps,
                         struct dem_history *list)
{
    int n = 0;

    for (int s = 0; sf != NULL && s < sf->n_chunks; s++) {
        const struct surface_histories *const f = &sf->chunk[s].saved;
        if (ps != NULL) surfaces_save_history(sf, s, ps);
        for (int q = 0; q < f->n; q++, n++) {
            if (list == NULL) continue;
            list[n].id = f->list[q].id;
            list[n].other = SURFACE_SPRING;
            memcpy(list[n].xi, f->list[q].xi, sizeof list[n].xi);
            memcpy(list[n].roll_angle, f->list[q].roll_angle,
                   sizeof list[n].roll_angle);
            memcpy(list[n].n, f->list[q].n, sizeof list[n].n);
        }
    }
    return n;
}

int surface_history_restore(struct surfaces *sf, const struct dem_history *list,
                            int n)
{
    int many = 0;

    for (int s = 0; sf != NULL && s < sf->n_chunks; s++)
        sf->chunk[s].saved.n = sf->chunk[s].current.n = 0;
    while (many < n && list[n - many - 1].other == SURFACE_SPRING)
        many++;
    for (int q = n - many; q < n && sf != NULL; q++) {
        struct surface_history one = {.id = list[q].id};
        memcpy(one.n, list[q].n, sizeof one.n);
        memcpy(one.xi, list[q].xi, sizeof one.xi);
        memcpy(one.roll_angle, list[q].roll_angle, sizeof one.roll_angle);
        surface_contacts_save(&sf->chunk[0].saved, &one);
    }
    return many;
}

/* --- surfaces checksum ---------------------------------------------------- */

/* Its place among the shapes. */
static int surfaces_shape_number(const struct surface_shape *shape)
{
    int i = 0;

    while (surface_shapes[i] != NULL && surface_shapes[i] != shape)
        i++;
    return i;
}

static unsigned long surfaces_checksum_add_shape(unsigned long sum,
                                                 const struct surface *s)
{
    const int whole[] = {surfaces_shape_number(s->shape), s->inside,
                         s->material};

    sum = crc32_z(sum, (const void *)whole, sizeof whole);
    if (s->shape->own_keys != NULL)
        sum = crc32_z(sum, (const void *)s->own, sizeof s->own);
    sum = crc32_z(sum, (const void *)s->point, sizeof s->point);
    sum = crc32_z(sum, (const void *)s->normal, sizeof s->normal);
    sum = crc32_z(sum, (const void *)&s->radius, sizeof s->radius);
    if (s->triangles == NULL) return sum;
    const size_t n = (size_t)s->triangles->n;
    return crc32_z(sum, (const void *)s->triangles->corner,
                   n * sizeof *s->triangles->corner);
}

static unsigned long surfaces_checksum_add_pair(unsigned long sum,
                                                const struct dem_options *o,
                                                int material)
{
    const struct material_pair p =
        materials_pair(&o->material, o->materials, 0, material);
    const double known[] = {p.of[1]->young, p.of[1]->poisson, p.stiffness,
                            p.tangential,   p.restitution,    p.friction,
                            p.rolling};

    sum = crc32_z(sum, (const void *)known, sizeof known);
    return o->law->own_keys != NULL
               ? crc32_z(sum, (const void *)p.of[1]->own, sizeof p.of[1]->own)
               : sum;
}

unsigned long surfaces_checksum(const struct dem_options *o)
{
    unsigned long sum = 0;

    for (int k = 0; k < o->n_surfaces; k++) {
        sum = surfaces_checksum_add_shape(sum, &o->surfaces[k]);
        if (o->materials != NULL)
            sum = surfaces_checksum_add_pair(sum, o, o->surfaces[k].material);
    }
    return sum;
}

/* --- dem surface ---------------------------------------------------------- */

struct dem_surface dem_surface(const struct dem *dem, int k)
{
    const struct surface_received a =
        surfaces_received(fast_of(dem)->neighbours->surfaces, k);
    struct dem_surface r = {.work = a.work,
                            .t = (double)dem->motion_steps * dem->options.step};

    r.pose = motion_pose(&dem->options.surfaces[k].motion, r.t);
    memcpy(r.force, a.force, sizeof r.force);
    memcpy(r.impulse, a.impulse, sizeof r.impulse);
    memcpy(r.angular, a.angular, sizeof r.angular);
    return r;
}

const struct wear_face *dem_surface_wear(const struct dem *dem, int k)
{
    const struct wear *const w = &fast_of(dem)->neighbours->surfaces->wear;
    return w->n > 0 && w->first[k] >= 0 ? &w->face[w->first[k]] : NULL;
}
