/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface_contacts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"

void near_faces_release(struct near_faces *l)
{
    free(l->owner);
    free(l->face);
    free(l->found.number);
}

static void begin_owner(struct near_faces *l, int i)
{
    l->owner =
        alloc_room(l->owner, l->n_owners, &l->owner_capacity, sizeof *l->owner);
    l->owner[l->n_owners++] = (struct near_owner){i, l->n_faces, l->n_faces};
}

static void near_faces_add_face(struct near_faces *l, const struct near_face *f)
{
    l->face =
        alloc_room(l->face, l->n_faces, &l->face_capacity, sizeof *l->face);
    l->face[l->n_faces++] = *f;
    l->owner[l->n_owners - 1].last = l->n_faces;
}

static void end_owner(struct near_faces *l)
{
    const struct near_owner *const o = &l->owner[l->n_owners - 1];
    if (o->first == o->last) l->n_owners--;
}

void near_faces_image(const struct near_face *f, const struct rows *b, int i,
                      double x[3])
{
    for (int k = 0; k < 3; k++) {
        const double dx = b->place[i].x[k] - b->listed[i][k];
        const double back = b->box.length[k] * rint(dx * b->box.inverse[k]);
        x[k] = b->place[i].x[k] - back + f->shift[k];
    }
}

static double gap_of(const struct surface_scene *scene, const struct pose *pose,
                     const struct near_face *f, const double x[3], double R)
{
    return surface_nearest_moved(&scene->surface[f->surface], f->face,
                                 &pose[f->surface], x)
               .r -
           R;
}

/* The faces of one surface near one image of a particle. */
static void near_faces_find_faces(struct near_faces *l,
                                  const struct surface_scene *scene,
                                  const struct pose *pose, int surface,
                                  const struct row_place *place,
                                  const double shift[3], double skin)
{
    const struct surface *const s = &scene->surface[surface];
    const int many = s->triangles != NULL;
    struct near_face f = {.surface = surface};
    double x[3], y[3];

    memcpy(f.shift, shift, sizeof f.shift);
    vector_along(place->x, 1.0, shift, x);
    motion_origin(&pose[surface], x, y);
    l->found.n = 1;
    if (many) triangles_near(s->triangles, y, place->R + skin, &l->found);
    for (int q = 0; q < l->found.n; q++) {
        f.face = many ? l->found.number[q] : 0;
        if (gap_of(scene, pose, &f, x, place->R) <= skin)
            near_faces_add_face(l, &f);
    }
}

/* A particle near an end of a periodic direction is near what lies beyond. */
static int images(const struct box_domain *box, const struct row_place *place,
                  int k, double skin, double shift[3])
{
    const double reach = place->R + skin;
    int n = 1;

    shift[0] = 0.0;
    if (!box->periodic[k]) return n;
    if (place->x[k] - box->lo[k] < reach) shift[n++] = box->length[k];
    if (box->hi[k] - place->x[k] < reach) shift[n++] = -box->length[k];
    return n;
}

static void find_owner(struct near_faces *l, const struct surface_scene *scene,
                       const struct pose *pose, const struct row_place *place,
                       double skin)
{
    double shift[3][3];
    int n[3];

    for (int k = 0; k < 3; k++)
        n[k] = images(scene->box, place, k, skin, shift[k]);
    for (int z = 0; z < n[2]; z++)
        for (int y = 0; y < n[1]; y++)
            for (int x = 0; x < n[0]; x++) {
                const double by[3] = {shift[0][x], shift[1][y], shift[2][z]};
                for (int s = 0; s < scene->n; s++)
                    near_faces_find_faces(l, scene, pose, s, place, by, skin);
            }
}

void near_faces_find(struct near_faces *l, const struct surface_scene *scene,
                     const struct pose *pose, const struct chunk *s,
                     const struct rows *b, double skin)
{
    l->n_owners = l->n_faces = 0;
    for (int i = s->begin; i < s->end; i++) {
        begin_owner(l, i);
        find_owner(l, scene, pose, &b->place[i], skin);
        end_owner(l);
    }
}

void near_faces_choose(struct near_faces *l, const struct near_faces *from,
                       const struct surface_scene *scene,
                       const struct pose *pose, const struct rows *b,
                       double margin)
{
    l->n_owners = l->n_faces = 0;
    for (int o = 0; o < from->n_owners; o++) {
        const struct near_owner *const own = &from->owner[o];
        begin_owner(l, own->owner);
        for (int f = own->first; f < own->last; f++) {
            const struct near_face *const face = &from->face[f];
            double x[3];
            near_faces_image(face, b, own->owner, x);
            if (gap_of(scene, pose, face, x, b->place[own->owner].R) < margin)
                near_faces_add_face(l, face);
        }
        end_owner(l);
    }
}

/* --- surface contact points ----------------------------------------------- */

/* Among those from `first` on, the nearest first; of two as near the one that
 * came first. */
static void
surface_contact_points_insert(struct surface_contact_points *t, int first,
                              const struct surface_contact_point *one)
{
    int at = t->n;

    t->list = alloc_room(t->list, t->n, &t->capacity, sizeof *t->list);
    for (; at > first && t->list[at - 1].r > one->r; at--)
        t->list[at] = t->list[at - 1];
    t->list[at] = *one;
    t->n++;
}

/* All faces that a particle overlaps. */
static void surface_contact_points_gather(struct surface_contact_points *t,
                                          const struct near_faces *close,
                                          const struct near_owner *own,
                                          const struct surface_scene *scene,
                                          const struct pose *pose,
                                          const struct rows *b)
{
    const int first = t->n;

    for (int f = own->first; f < own->last; f++) {
        const struct near_face *const face = &close->face[f];
        const struct pose *const p = &pose[face->surface];
        double x[3];

        near_faces_image(face, b, own->owner, x);
        const struct surface_hit h = surface_nearest_moved(
            &scene->surface[face->surface], face->face, p, x);
        if (h.r >= b->place[own->owner].R) continue;
        struct surface_contact_point one = {.owner = own->owner,
                                            .surface = face->surface,
                                            .face = face->face,
                                            .r = h.r};
        memcpy(one.n, h.n, sizeof one.n);
        memcpy(one.q, h.q, sizeof one.q);
        motion_velocity(p, h.q, one.v);
        surface_contact_points_insert(t, first, &one);
    }
}

/* 1 if the point t lies behind the plane through the nearer one (14.5). */
static int hides(const struct surface_contact_point *nearer,
                 const struct surface_contact_point *t, double R)
{
    return nearer->r - t->r * vector_dot(t->n, nearer->n) <=
           surface_contact_points_flat * R;
}

/* A hidden face still hides others: a point behind it is no separate contact
 * either. Therefore the faces that count are marked first and compacted
 * afterwards. */
static void keep_those_that_count(struct surface_contact_points *t, int first,
                                  double R)
{
    int n = first;

    for (int k = t->n - 1; k > first; k--)
        for (int s = first; s < k; s++)
            if (hides(&t->list[s], &t->list[k], R)) {
                t->list[k].owner = -1;
                break;
            }
    for (int k = first; k < t->n; k++)
        if (t->list[k].owner >= 0) t->list[n++] = t->list[k];
    t->n = n;
}

void surface_contact_points_find(struct surface_contact_points *t,
                                 const struct near_faces *close,
                                 const struct surface_scene *scene,
                                 const struct pose *pose, const struct rows *b)
{
    t->n = 0;
    for (int o = 0; o < close->n_owners; o++) {
        const struct near_owner *const own = &close->owner[o];
        const int first = t->n;

        surface_contact_points_gather(t, close, own, scene, pose, b);
        keep_those_that_count(t, first, b->place[own->owner].R);
    }
}
