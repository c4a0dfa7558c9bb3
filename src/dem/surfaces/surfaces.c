/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surfaces.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/triangles.h"

/* The highest speed of any point of the surfaces in the box [m/s]. */
static double highest_speed(const struct surface_scene *scene)
{
    double speed = 0.0;

    for (int k = 0; k < scene->n; k++) {
        const struct surface *const one = &scene->surface[k];
        const double reach = surface_reach(one, scene->box->lo, scene->box->hi);
        speed = fmax(speed, motion_speed(&one->motion, reach));
        speed = fmax(speed, one->load.speed);
    }
    return speed;
}

struct surfaces *surfaces_create(const struct surface *list, int n,
                                 const struct box_domain *box, int count)
{
    struct surfaces *const sf = owner_create(sizeof *sf);

    sf->wear = wear_create(sf, list, n);
    sf->scene = (struct surface_scene){list, n, box, sf->wear.n > 0, 0};
    sf->n_chunks = count;
    sf->chunk = owner_zeroed(sf, (size_t)count, sizeof *sf->chunk);
    for (int s = 0; s < count; s++)
        surface_contacts_init(&sf->chunk[s], sf, &sf->scene);
    sf->speed = highest_speed(&sf->scene);
    for (int k = 0; k < n; k++) {
        sf->carried |= list[k].motion.carrier != NULL;
        sf->scene.loaded |= list[k].load.speed > 0.0;
    }
    return sf;
}

void surfaces_free(struct surfaces *sf)
{
    if (sf == NULL) return;
    for (int s = 0; s < sf->n_chunks; s++)
        surface_contacts_release(&sf->chunk[s]);
    free(sf->index_of_id);
    owner_free(sf);
}

void surfaces_move(struct surfaces *sf, int s, double t)
{
    struct surface_contacts *const c = &sf->chunk[s];

    if (t == c->time) return;
    c->time = t;
    for (int k = 0; k < sf->scene.n; k++)
        if (motion_is_any(&sf->scene.surface[k].motion))
            c->pose[k] = motion_pose(&sf->scene.surface[k].motion, t);
}

/* v (Z + eta) = W - F + eta v_before along W, at most `speed`, which it has
 * while it touches nothing: with the impedance Z of what it touches, so that it
 * takes up a wave as more of the same would; and with the part eta of the
 * contacts' dashpots that is in F, for the new v. */
static void follow_load(const struct surfaces *sf, int k, double t)
{
    const struct surface *const s = &sf->scene.surface[k];
    struct carrier *const c = s->load.carrier;
    const struct surface_received got = surfaces_received(sf, k);
    const double W = vector_length(s->load.force), most = s->load.speed;
    const double F = -vector_dot(got.force, s->load.force) / W;
    const double before = vector_dot(c->pose.velocity, s->load.force) / W;
    const double resists = got.impedance + got.damping;
    double v = most;

    if (resists > 0.0) v = (W - F + got.damping * before) / resists;
    v = motion_is_on(&s->motion, t) ? fmax(-most, fmin(most, v)) : 0.0;
    vector_along(c->pose.centre, t - c->t, c->pose.velocity, c->pose.centre);
    c->t = t;
    for (int a = 0; a < 3; a++)
        c->pose.velocity[a] = v / W * s->load.force[a];
}

void surfaces_follow_loads(struct surfaces *sf, double t)
{
    for (int k = 0; k < sf->scene.n; k++)
        if (sf->scene.surface[k].load.speed > 0.0) follow_load(sf, k, t);
}

double surfaces_moved(const struct surfaces *sf, int s)
{
    const struct surface_contacts *const c = &sf->chunk[s];
    double way[3], farthest = sf->speed * fabs(c->time - c->built_time);

    for (int k = 0; k < sf->scene.n; k++) {
        if (sf->scene.surface[k].motion.carrier == NULL) continue;
        vector_between(c->pose[k].centre, c->built[k].centre, way);
        farthest = fmax(farthest, vector_length(way));
    }
    return farthest;
}

void surfaces_save_history(struct surfaces *sf, int s,
                           const struct particles *ps)
{
    struct surface_contacts *const c = &sf->chunk[s];

    c->saved.n = 0;
    for (int q = 0; q < c->current.n; q++) {
        struct surface_history one = c->current.list[q];
        one.id = ps->id[one.owner];
        surface_contacts_save(&c->saved, &one);
    }
}

void surfaces_locate_particles(struct surfaces *sf, const struct particles *ps)
{
    int highest = -1;

    for (int i = 0; i < ps->n; i++)
        highest = ps->id[i] > highest ? ps->id[i] : highest;
    if (highest >= sf->index_capacity) {
        free(sf->index_of_id);
        sf->index_capacity = highest + highest / 2 + 1;
        sf->index_of_id = alloc_ints(sf->index_capacity);
    }
    for (int id = 0; id < sf->index_capacity; id++)
        sf->index_of_id[id] = -1;
    for (int i = 0; i < ps->n; i++)
        sf->index_of_id[ps->id[i]] = i;
}

/* Collects the histories of the particles of this chunk from all chunks. */
static void restore(struct surfaces *sf, int s, const struct chunk *chunk)
{
    struct surface_histories *const now = &sf->chunk[s].current;

    now->n = 0;
    for (int t = 0; t < sf->n_chunks; t++) {
        const struct surface_histories *const kept = &sf->chunk[t].saved;
        for (int q = 0; q < kept->n; q++) {
            struct surface_history one = kept->list[q];
            one.owner =
                one.id < sf->index_capacity ? sf->index_of_id[one.id] : -1;
            if (one.owner >= chunk->begin && one.owner < chunk->end)
                surface_contacts_save(now, &one);
        }
    }
    surface_contacts_sort(now);
}

void surfaces_find(struct surfaces *sf, int s, const struct chunk *chunk,
                   const struct rows *b, double skin)
{
    struct surface_contacts *const c = &sf->chunk[s];

    restore(sf, s, chunk);
    near_faces_find(&c->list, &sf->scene, c->pose, chunk, b, skin);
    memcpy(c->built, c->pose, (size_t)sf->scene.n * sizeof *c->built);
    c->built_time = c->time;
}

/* Chooses, for chunk s, the faces that are nearer than the margin [m]. */
void surfaces_choose_contacts(struct surfaces *sf, int s, const struct rows *b,
                              double margin)
{
    struct surface_contacts *const c = &sf->chunk[s];
    near_faces_choose(&c->close, &c->list, &sf->scene, c->pose, b, margin);
}

void surfaces_add_loads(struct surfaces *sf, int s, struct chunk *chunk,
                        const struct rows *b, const struct contact_constants *k,
                        double dt)
{
    surface_contacts_add_loads(&sf->chunk[s], &sf->scene, chunk, b, k, dt);
}

void surfaces_wear(struct surfaces *sf, double dt)
{
    for (int s = 0; s < sf->n_chunks && sf->wear.n > 0; s++)
        for (int q = 0; q < sf->chunk[s].touches.n; q++) {
            const struct surface_contact_point *const t =
                &sf->chunk[s].touches.list[q];
            if (sf->wear.first[t->surface] < 0) continue;
            struct wear_face *const to =
                &sf->wear.face[sf->wear.first[t->surface] + t->face];
            const double *const F = sf->chunk[s].pairs.load[2 * q].F;
            double shear[3];

            vector_along(F, -t->F_n, t->n, shear);
            to->worn += t->worn;
            to->normal += dt * t->F_n;
            to->shear += dt * vector_length(shear);
        }
}

/* The path of particle i since the last rebuild, in the frame of the surface.
 */
static int crosses(const struct surface_contacts *c,
                   const struct surface_scene *scene, int surface, int face,
                   const double shift[3], const struct rows *b, int i)
{
    const struct near_face at = {surface, face, {shift[0], shift[1], shift[2]}};
    double x[3], old[3], from[3], to[3];

    vector_along(b->listed[i], 1.0, shift, old);
    near_faces_image(&at, b, i, x);
    motion_origin(&c->built[surface], old, from);
    motion_origin(&c->pose[surface], x, to);
    return triangle_crossed(
        (const double(*)[3])scene->surface[surface].triangles->corner[face],
        from, to);
}

/* For a particle too fast for the lists all triangles are tested. */
static int jumps_through(const struct surface_contacts *c,
                         const struct surface_scene *scene, int surface,
                         const struct rows *b, int i)
{
    static const double here[3] = {0.0, 0.0, 0.0};

    if (scene->surface[surface].triangles == NULL) return 0;
    for (int f = 0; f < scene->surface[surface].triangles->n; f++)
        if (crosses(c, scene, surface, f, here, b, i)) return 1;
    return 0;
}

static double moved2(const struct rows *b, int i)
{
    const struct near_face none = {0};
    double x[3], way[3];

    near_faces_image(&none, b, i, x);
    vector_between(x, b->listed[i], way);
    return vector_dot(way, way);
}

static void record_lost(struct rows_survey *found, int i, int surface)
{
    if (found->lost++ > 0) return;
    found->first_lost = i;
    found->lost_through = surface;
}

/* The surface that contains particle i or that it has passed through; or -1. */
static int surfaces_beyond(const struct surface_contacts *c,
                           const struct surface_scene *scene,
                           const struct rows *b, int i, int fast)
{
    for (int k = 0; k < scene->n; k++)
        if (surface_contains(&scene->surface[k], &c->pose[k], b->place[i].x,
                             b->place[i].R) ||
            (fast && jumps_through(c, scene, k, b, i)))
            return k;
    return -1;
}

/* The surface near an owner that it has crossed, or -1. */
static int crossed(const struct surface_contacts *c,
                   const struct surface_scene *scene, const struct rows *b,
                   const struct near_owner *own)
{
    for (int f = own->first; f < own->last; f++) {
        const struct near_face *const face = &c->list.face[f];
        if (scene->surface[face->surface].triangles != NULL &&
            crosses(c, scene, face->surface, face->face, face->shift, b,
                    own->owner))
            return face->surface;
    }
    return -1;
}

void surfaces_check_lost(const struct surfaces *sf, int s,
                         const struct chunk *chunk, const struct rows *b,
                         int marks, double skin, struct rows_survey *found)
{
    const struct surface_contacts *const c = &sf->chunk[s];

    if (found->lost > 0) return;
    for (int i = chunk->begin; i < chunk->end; i++) {
        const int fast = marks && moved2(b, i) > skin * skin;
        const int surface = surfaces_beyond(c, &sf->scene, b, i, fast);
        if (surface >= 0) record_lost(found, i, surface);
    }
    if (!marks || found->lost > 0) return;
    for (int o = 0; o < c->list.n_owners; o++) {
        const struct near_owner *const own = &c->list.owner[o];
        const int surface = crossed(c, &sf->scene, b, own);
        if (surface >= 0) record_lost(found, own->owner, surface);
    }
}

/* Between two runs a carrier may have changed its velocity, or come back into a
 * periodic box. */
static void update_carried(struct surfaces *sf)
{
    sf->speed = highest_speed(&sf->scene);
    for (int s = 0; s < sf->n_chunks; s++)
        for (int k = 0; k < sf->scene.n; k++) {
            const struct motion *const m = &sf->scene.surface[k].motion;
            if (m->carrier != NULL)
                sf->chunk[s].pose[k] = motion_pose(m, sf->chunk[s].time);
        }
}

void surfaces_begin_run(struct surfaces *sf)
{
    for (int s = 0; s < sf->n_chunks; s++)
        sf->chunk[s].pairs.max_overlap = 0.0;
    if (sf->carried) update_carried(sf);
}

struct surface_received surfaces_received(const struct surfaces *sf,
                                          int surface)
{
    struct surface_received sum = {.work = 0.0};

    for (int s = 0; s < sf->n_chunks; s++) {
        const struct surface_received *const a =
            &sf->chunk[s].received[surface];
        for (int k = 0; k < 3; k++) {
            sum.impulse[k] += a->impulse[k];
            sum.angular[k] += a->angular[k];
            sum.force[k] += a->force[k];
        }
        sum.work += a->work;
        sum.impedance += a->impedance;
        sum.damping += a->damping;
    }
    return sum;
}
