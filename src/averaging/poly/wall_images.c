/* SPDX-License-Identifier: GPL-3.0-or-later */
/* For each cell: the facets of walls around it, the planes they lie on, and
 * then its images, those of images among them, one plane after the other. All
 * places are given from the centre of the cell.
 *
 * An image h behind a wall is at 2 h from the cell, and what is nearer to it
 * than that wall is within 3 h of the cell. So facets are looked for as far as
 * three times the reach. */
#include "averaging/poly/facets.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

enum { MOST_TURNS = 10000 }; /* the case allows no more */

/* Planes, positions and distances closer than this are treated as equal,
 * because files give coordinates with six digits. */
static const double same = 1e-5; /* [-] of the reach, or a sine */

/* A facet of a wall. */
struct mirror_wall {
    int j;                 /* [-] of the facets */
    double n[3];           /* [-] normal out of the mesh */
    double mid[3], radius; /* [m] a ball that holds it */
};

/* A facet of a wall, relative to a cell. */
struct mirror_image {
    const struct mirror_wall *wall;
    int plane;       /* [-] which one it lies on */
    double shift[3]; /* [m] what leads from its points to where it is seen */
    double mid[3];   /* [m] */
    double away;     /* [m] from the cell to the ball */
};

struct plane {
    double n[3]; /* [-] normal out of the mesh */
    double h;    /* [m] n . x of its points */
};

/* The walls and images found from one cell. */
struct mirror_search {
    const struct facets *f;
    double reach;
    struct mirror_wall *wall; /* all */
    int n_walls, turns[3];    /* [-] of each period that matter */
    struct mirror_image *seen;
    struct plane *plane;
    struct wall_image *place; /* the first is the cell itself */
    int n_seen, n_planes, n_places;
    int image_capacity, plane_capacity, place_capacity;
};

/* The plane with that normal through the point, a new one if need be. */
static int plane_of(struct mirror_search *v, const double n[3],
                    const double x[3])
{
    const double h = vector_dot(n, x);

    for (int k = 0; k < v->n_planes; k++) {
        const struct plane *const p = &v->plane[k];
        double off[3];
        vector_between(p->n, n, off);
        if (vector_length(off) < same && fabs(p->h - h) < same * v->reach)
            return k;
    }
    v->plane =
        alloc_room(v->plane, v->n_planes, &v->plane_capacity, sizeof *v->plane);
    v->plane[v->n_planes] = (struct plane){{n[0], n[1], n[2]}, h};
    return v->n_planes++;
}

static void wall_images_add_wall(struct mirror_search *v, int j,
                                 const double S[3])
{
    const struct facets *const f = v->f;
    const int first = f->start[j], n = f->start[j + 1] - first;
    const double *const normal = &f->normal[3 * j];
    struct mirror_wall w = {.j = j};

    for (int k = 0; k < 3; k++)
        w.n[k] = vector_dot(normal, S) > 0.0 ? normal[k] : -normal[k];
    for (int i = 0; i < n; i++)
        vector_along(w.mid, 1.0 / n, &f->point[3 * f->corner[first + i]],
                     w.mid);
    for (int i = 0; i < n; i++) {
        double r[3];
        vector_between(&f->point[3 * f->corner[first + i]], w.mid, r);
        w.radius = fmax(w.radius, vector_length(r));
    }
    v->wall[v->n_walls++] = w;
}

/* The facets of all boundary faces, and how far round the periods they are to
 * be looked for. */
static void collect_walls(struct mirror_search *v)
{
    const struct mesh *const m = v->f->mesh;
    const int *const of = v->f->of, *const boundary = m->shape->boundary;
    int n = 0;

    for (int b = 0; b < m->n_faces - m->n_internal; b++)
        n += of[boundary[b] + 1] - of[boundary[b]];
    v->wall = alloc_zeroed((size_t)n + 1, sizeof *v->wall);
    for (int b = 0; b < m->n_faces - m->n_internal; b++)
        for (int j = of[boundary[b]]; j < of[boundary[b] + 1]; j++)
            wall_images_add_wall(v, j, mesh_S(m, b + m->n_internal));
    for (int k = 0; k < m->n_periods; k++)
        v->turns[k] =
            1 +
            number_clamped(ceil(3.0 * v->reach / vector_length(m->period[k])),
                           0, MOST_TURNS);
}

/* All walls that are moved by the shift and then near. */
static void collect_moved(struct mirror_search *v, const double shift[3])
{
    for (int i = 0; i < v->n_walls; i++) {
        const struct mirror_wall *const w = &v->wall[i];
        struct mirror_image s = {.wall = w};
        vector_along(w->mid, 1.0, shift, s.mid);
        s.away = vector_length(s.mid) - w->radius;
        if (s.away > 3.0 * v->reach) continue;
        memcpy(s.shift, shift, sizeof s.shift);
        v->seen = alloc_room(v->seen, v->n_seen, &v->image_capacity, sizeof s);
        v->seen[v->n_seen++] = s;
    }
}

static int nearer_first(const void *a, const void *b)
{
    const struct mirror_image *const s = a, *const t = b;

    if (s->away != t->away) return s->away < t->away ? -1 : 1;
    return s->wall->j - t->wall->j;
}

/* The walls around cell c, the nearest first, and their planes; none at all if
 * none is within reach. */
static void collect_images(struct mirror_search *v, int c)
{
    const struct mesh *const m = v->f->mesh;
    const int *const turns = v->turns;

    v->n_seen = v->n_planes = 0;
    for (int i = -turns[0]; i <= turns[0]; i++)
        for (int j = -turns[1]; j <= turns[1]; j++)
            for (int k = -turns[2]; k <= turns[2]; k++) {
                double shift[3] = {0.0, 0.0, 0.0};
                vector_along(shift, -1.0, &m->centre[3 * c], shift);
                vector_along(shift, i, m->period[0], shift);
                vector_along(shift, j, m->period[1], shift);
                vector_along(shift, k, m->period[2], shift);
                collect_moved(v, shift);
            }
    if (v->n_seen == 0) return;
    qsort(v->seen, (size_t)v->n_seen, sizeof *v->seen, nearer_first);
    if (v->seen[0].away > v->reach) v->n_seen = 0;
    for (int i = 0; i < v->n_seen; i++)
        v->seen[i].plane = plane_of(v, v->seen[i].wall->n, v->seen[i].mid);
}

/* The square of the distance from z to the line from a to b [m^2]. */
static double to_edge(const double z[3], const double a[3], const double e[3])
{
    double r[3], rest[3];

    vector_between(z, a, r);
    const double t = vector_dot(r, e) / fmax(vector_dot(e, e), 1e-300);
    vector_along(r, -fmax(0.0, fmin(1.0, t)), e, rest);
    return vector_dot(rest, rest);
}

/* From the point x to the facet [m]. */
static double wall_images_distance(const struct mirror_search *v,
                                   const struct mirror_image *s,
                                   const double x[3])
{
    const struct facets *const f = v->f;
    const int first = f->start[s->wall->j],
              n = f->start[s->wall->j + 1] - first;
    const double *const normal = &f->normal[3 * s->wall->j];
    double z[3], least = INFINITY, off = 0.0;
    int above = 1;

    vector_between(x, s->shift, z);
    for (int i = 0; i < n; i++) {
        const double *const a = &f->point[3 * f->corner[first + i]];
        const double *const b = &f->point[3 * f->corner[first + (i + 1) % n]];
        double e[3], r[3], inward[3];
        vector_between(b, a, e);
        vector_between(z, a, r);
        vector_cross(normal, e, inward);
        if (vector_dot(r, inward) < 0.0) above = 0;
        least = fmin(least, to_edge(z, a, e));
        off = fabs(vector_dot(r, normal));
    }
    return above ? off : sqrt(least);
}

/* From x to the nearest facet on plane k [m]. */
static double to_plane(const struct mirror_search *v, int k, const double x[3])
{
    double least = INFINITY;

    for (int i = 0; i < v->n_seen; i++)
        if (v->seen[i].plane == k)
            least = fmin(least, wall_images_distance(v, &v->seen[i], x));
    return least;
}

/* Weight of plane k for the point x, which is h [m] beyond it: 1 if this wall
 * is the nearest, and of several equally near walls the one that x is farthest
 * beyond; a fraction if several are equal in both; else 0. */
static double wall_images_part_of(const struct mirror_search *v, int k,
                                  const double x[3], double h)
{
    enum { TIES = 8 };
    const double tiny = same * v->reach, own = to_plane(v, k, x);
    int tied[TIES] = {k}, ties = 1;

    for (int i = 0; i < v->n_seen; i++) {
        const struct mirror_image *const s = &v->seen[i];
        double r[3];
        vector_between(x, s->mid, r);
        if (s->plane == k || vector_length(r) - s->wall->radius > own + tiny)
            continue;
        const double d = wall_images_distance(v, s, x);
        if (d > own + tiny) continue;
        if (d < own - tiny) return 0.0;
        const struct plane *const p = &v->plane[s->plane];
        const double beyond = vector_dot(p->n, x) - p->h;
        if (beyond > h + tiny) return 0.0;
        int known = beyond < h - tiny;
        for (int t = 0; t < ties; t++)
            known |= tied[t] == s->plane;
        if (!known && ties < TIES) tied[ties++] = s->plane;
    }
    return 1.0 / ties;
}

/* Adds an image, or adds the weight to an existing image at the same position.
 */
static void add_place(struct mirror_search *v, const struct wall_image *q)
{
    for (int i = 0; i < v->n_places; i++) {
        double r[3];
        vector_between(v->place[i].offset, q->offset, r);
        if (vector_length(r) > 3.0 * same * v->reach) continue;
        v->place[i].weight += q->weight;
        return;
    }
    v->place =
        alloc_room(v->place, v->n_places, &v->place_capacity, sizeof *v->place);
    v->place[v->n_places++] = *q;
}

/* The reflection of position i in plane k [EW18 21], if it is within reach and
 * belongs to this plane. */
static void mirror(struct mirror_search *v, int i, int k)
{
    const struct plane *const p = &v->plane[k];
    const struct wall_image *const from = &v->place[i];
    const double h = p->h - vector_dot(p->n, from->offset);
    struct wall_image q;

    if (h <= same * v->reach || h > v->reach) return;
    vector_along(from->offset, 2.0 * h, p->n, q.offset);
    if (vector_length(q.offset) > 2.0 * v->reach) return;
    q.weight = from->weight * wall_images_part_of(v, k, q.offset, h);
    if (q.weight == 0.0) return;
    for (int col = 0; col < 3; col++) {
        double n_turn = 0.0;
        for (int row = 0; row < 3; row++)
            n_turn += p->n[row] * from->rotation[3 * row + col];
        for (int row = 0; row < 3; row++)
            q.rotation[3 * row + col] =
                from->rotation[3 * row + col] - 2.0 * p->n[row] * n_turn;
    }
    add_place(v, &q);
}

static void search_from(struct mirror_search *v, int c)
{
    static const struct wall_image here = {
        {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, 1.0};

    collect_images(v, c);
    v->n_places = 0;
    add_place(v, &here);
    for (int i = 0; i < v->n_places; i++) /* grows as images are found */
        for (int k = 0; k < v->n_planes; k++)
            mirror(v, i, k);
}

struct wall_images *wall_images_create(const struct facets *f, double reach)
{
    const int n_cells = f->mesh->n_cells;
    struct wall_images *const m = owner_create(sizeof *m);
    struct mirror_search v = {.f = f, .reach = reach};
    int n = 0, room = 0;

    m->start = owner_ints(m, n_cells + 1);
    collect_walls(&v);
    for (int c = 0; c < n_cells; c++) {
        search_from(&v, c);
        for (int i = 1; i < v.n_places; i++) {
            m->images = alloc_room(m->images, n, &room, sizeof *m->images);
            m->images[n++] = v.place[i];
        }
        m->start[c + 1] = n;
    }
    free(v.wall);
    free(v.seen);
    free(v.plane);
    free(v.place);
    return m;
}

void wall_images_free(struct wall_images *m)
{
    if (m == NULL) return;
    free(m->images);
    owner_free(m);
}
