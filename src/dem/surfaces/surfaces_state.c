/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surfaces_state.c -- the visit of the surfaces.  Chapter "Nothing is lost". */
#include "dem/surfaces/surfaces.h"

#include <limits.h>
#include <stdlib.h>

#include "base/alloc.h"

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

void near_faces_state(struct near_faces *l, const char *name,
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
                                     const char *name, int capacity,
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
    surfaces_state_histories(&c->current, "current", capacity, s);
    surfaces_state_histories(&c->saved, "saved", capacity, s);
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

void surfaces_state(struct surfaces *sf, const struct chunk *chunks,
                    int capacity, struct state *s)
{
    state_begin(s, "surfaces");
    for (int k = 0; k < sf->n_chunks; k++) {
        struct surface_contacts *const c = &sf->chunk[k];
        state_begin_number(s, "chunk", k);
        surfaces_state_contacts(c, &sf->scene, &chunks[k], capacity, s);
        if (s->loading) set_poses(c, &sf->scene);
        if (sf->carried) carried_state(c, sf->scene.n, s);
        state_end(s);
    }
    state_end(s);
}
