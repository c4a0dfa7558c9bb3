/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surface_contact_points.h"

#include <string.h>

#include "base/vector.h"

/* Among those from `first` on, the nearest first; of two as near the one that
 * came first. */
static void
surface_contact_points_insert(struct surface_contact_points *t, int first,
                              const struct surface_contact_point *one)
{
    int at = t->n;

    t->list = near_faces_room(t->list, t->n, &t->capacity, sizeof *t->list);
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
                                          const struct bodies *b)
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
        struct surface_contact_point one = {
            .owner = own->owner, .surface = face->surface, .r = h.r};
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
                                 const struct pose *pose,
                                 const struct bodies *b)
{
    t->n = 0;
    for (int o = 0; o < close->n_owners; o++) {
        const struct near_owner *const own = &close->owner[o];
        const int first = t->n;

        surface_contact_points_gather(t, close, own, scene, pose, b);
        keep_those_that_count(t, first, b->place[own->owner].R);
    }
}
