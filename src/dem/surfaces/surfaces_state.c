/* SPDX-License-Identifier: GPL-3.0-or-later */
/* surfaces_state.c -- the visit of the surfaces.  Chapter "Nothing is lost". */
#include "dem/surfaces/surfaces.h"

#include <limits.h>
#include <stdlib.h>

#include "base/alloc.h"

void near_faces_state(struct near_faces *l, const char *name, struct state *s)
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
    state_wholes_of(s, "owner", "-", &l->owner->owner, owner, l->n_owners, 1);
    state_wholes_of(s, "first", "-", &l->owner->first, owner, l->n_owners, 1);
    state_wholes_of(s, "last", "-", &l->owner->last, owner, l->n_owners, 1);
    state_wholes_of(s, "surface", "-", &l->face->surface, face, l->n_faces, 1);
    state_wholes_of(s, "face", "-", &l->face->face, face, l->n_faces, 1);
    state_reals_of(s, "shift", "m", l->face->shift, face, l->n_faces, 3);
    state_end(s);
}

static void histories_state(struct surface_histories *f, const char *name,
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
    state_wholes_of(s, "owner", "-", &all->owner, sizeof *all, f->n, 1);
    state_wholes_of(s, "id", "-", &all->id, sizeof *all, f->n, 1);
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

static void contacts_state(struct surface_contacts *c, int n, struct state *s)
{
    struct surface_received *const all = c->received;

    state_real(s, "time", "s", &c->time);
    state_real(s, "built_time", "s", &c->built_time);
    near_faces_state(&c->list, "list", s);
    near_faces_state(&c->close, "close", s);
    histories_state(&c->current, "current", s);
    histories_state(&c->saved, "saved", s);
    state_reals_of(s, "impulse", "N s", all->impulse, sizeof *all, n, 3);
    state_reals_of(s, "angular", "N m s", all->angular, sizeof *all, n, 3);
    state_reals_of(s, "work", "J", &all->work, sizeof *all, n, 1);
    chunk_energy_state(&c->pairs.energy, s);
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

void surfaces_state(struct surfaces *sf, struct state *s)
{
    state_begin(s, "surfaces");
    for (int k = 0; k < sf->n_chunks; k++) {
        struct surface_contacts *const c = &sf->chunk[k];
        state_begin_number(s, "chunk", k);
        contacts_state(c, sf->scene.n, s);
        if (s->loading) set_poses(c, &sf->scene);
        if (sf->carried) carried_state(c, sf->scene.n, s);
        state_end(s);
    }
    state_end(s);
}
