/* SPDX-License-Identifier: GPL-3.0-or-later */
/* closed_surface.c -- a body within a closed surface of triangles, and how thin
 * it is. */
#include "resolved/shapes/shapes.h"

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/triangles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- thickness ------------------------------------------------------------ */

/* How thin a body of triangles is.
 * Chapter "Resolving the grains".
 *
 * At a point of the surface the body is as thick as the way along the inward
 * normal until it leaves the body. */
/* Shares of the area that are looked at, each at the centroid of the triangle
 * that it falls into [-]. */
enum { POINTS = 100, THINNER = POINTS / 10 };

/* A way that meets an edge meets one of its triangles for certain [-]. */
static const double beyond_edge = 1e-9;

static void sides_of(double x[3][3], double ab[3], double ac[3], double area[3])
{
    vector_between(x[1], x[0], ab);
    vector_between(x[2], x[0], ac);
    vector_cross(ab, ac, area);
}

/* How far it is from p along n to the triangle [m], from its inner side;
 * HUGE_VAL: the way passes it by. Where it meets the plane of the triangle, the
 * weights of the corners b and c are e . ac and -e . ab over n . area, with
 * e = n x (p - a). */
static double way_to(double x[3][3], const double p[3], const double n[3])
{
    double ab[3], ac[3], area[3], from[3], e[3];

    sides_of(x, ab, ac, area);
    const double along = vector_dot(n, area);
    if (!(along > 0.0)) return HUGE_VAL;
    vector_between(p, x[0], from);
    vector_cross(n, from, e);
    const double b = vector_dot(e, ac) / along, c = -vector_dot(e, ab) / along;
    if (fmin(fmin(b, c), 1.0 - b - c) < -beyond_edge) return HUGE_VAL;
    return -vector_dot(from, area) / along;
}

static double thickness_at(int n, double (*corner)[3][3], int t)
{
    double ab[3], ac[3], area[3], p[3], least = HUGE_VAL;

    sides_of(corner[t], ab, ac, area);
    const double per = -1.0 / vector_length(area);
    for (int k = 0; k < 3; k++) {
        p[k] = (corner[t][0][k] + corner[t][1][k] + corner[t][2][k]) / 3.0;
        area[k] *= per;
    }
    for (int o = 0; o < n; o++) {
        const double way = o == t ? HUGE_VAL : way_to(corner[o], p, area);
        if (way > 0.0) least = fmin(least, way);
    }
    return least;
}

static int by_size(const void *a, const void *b)
{
    const double *const p = a, *const q = b;
    return (*p > *q) - (*p < *q);
}

static double thickness_area_of(double x[3][3])
{
    double ab[3], ac[3], area[3];

    sides_of(x, ab, ac, area);
    return vector_length(area);
}

/* A tenth of the surface is where the body is thinner than this [m]. The
 * triangles have areas, their normals point outward. */
static double thickness_of(int n, double (*corner)[3][3])
{
    double all[POINTS], whole = 0.0, passed;

    for (int t = 0; t < n; t++)
        whole += thickness_area_of(corner[t]);
    passed = thickness_area_of(corner[0]);
    for (int k = 0, t = 0; k < POINTS; k++) {
        while (passed < (k + 0.5) / POINTS * whole && t + 1 < n)
            passed += thickness_area_of(corner[++t]);
        all[k] = thickness_at(n, corner, t);
    }
    qsort(all, POINTS, sizeof *all, by_size);
    return all[THINNER];
}

/* --- closed surface ------------------------------------------------------- */

struct closed_surface {
    struct body_outline outline; /* first, because the body gives it back */
    double (*corner)[3][3];
    struct triangle_tree *tree;
    int *last; /* [-] the nearest of the last point */
    /* [-] of each triangle; across the edge from corner k to the next one; in
     * corner k. Not of length 1 but for the first. */
    double (*face)[3], (*edge)[3][3], (*point)[3][3];
};

/* Below this weight of a corner, a point lies on the edge opposite [-]: what
 * rounding makes of 0. */
static const double on_edge = 1e-9;

/* The normal where q is on triangle t. */
static const double *normal_at(const struct closed_surface *s, int t,
                               const double q[3])
{
    double(*const x)[3] = s->corner[t], ab[3], ac[3], area[3];
    int on = 0,
        off = 0; /* corners with a weight: the last; how many have none */

    sides_of(x, ab, ac, area);
    for (int k = 0; k < 3; k++) {
        double from[3], to[3], part[3];
        vector_between(x[(k + 1) % 3], q, from);
        vector_between(x[(k + 2) % 3], q, to);
        vector_cross(from, to, part);
        if (vector_dot(part, area) > on_edge * vector_dot(area, area))
            on += 1 << k;
        else
            off++;
    }
    if (off == 0) return s->face[t];
    if (off == 1) /* without corner 0: the edge from 1 to 2 */
        return s->edge[t][on == 6 ? 1 : on == 5 ? 2 : 0];
    return s->point[t][on == 4 ? 2 : on == 2 ? 1 : 0];
}

static double closed_surface_distance(const struct body_outline *o,
                                      const double y[3])
{
    const struct closed_surface *const s = (const struct closed_surface *)o;
    double q[3], r[3];

    *s->last = triangle_tree_nearest(s->tree, y, *s->last, q);
    vector_between(y, q, r);
    const double far = vector_length(r);
    return vector_dot(r, normal_at(s, *s->last, q)) < 0.0 ? -far : far;
}

/* --- volume and moments --------------------------------------------------- */

/* Of the tetrahedra between the origin and each triangle, with their signs. */
static void closed_surface_set_moments(struct body_outline *o, int n,
                                       double (*corner)[3][3])
{
    const int *const row = body_outline_row, *const column =
                                                 body_outline_column;
    double V = 0.0, first[3] = {0}, second[6] = {0};

    for (int t = 0; t < n; t++) {
        const double(*const x)[3] = (const double(*)[3])corner[t];
        double area[3], sum[3];
        vector_cross(x[1], x[2], area);
        const double part = vector_dot(x[0], area) / 6.0;
        V += part;
        for (int k = 0; k < 3; k++) {
            sum[k] = x[0][k] + x[1][k] + x[2][k];
            first[k] += 0.25 * part * sum[k];
        }
        for (int e = 0; e < 6; e++) {
            const int a = row[e], b = column[e];
            second[e] += 0.05 * part *
                         (sum[a] * sum[b] + x[0][a] * x[0][b] +
                          x[1][a] * x[1][b] + x[2][a] * x[2][b]);
        }
    }
    body_outline_set_moments(o, V, first, second);
}

static void turn_over(int n, double (*corner)[3][3])
{
    for (int t = 0; t < n; t++) {
        double other[3];
        memcpy(other, corner[t][1], sizeof other);
        memcpy(corner[t][1], corner[t][2], sizeof other);
        memcpy(corner[t][2], other, sizeof other);
    }
}

/* --- corners and edges that triangles have in common ---------------------- */

struct corner {
    double x[3];
    int at; /* [-] 3 t + k */
};

struct edge {
    int from, to; /* [-] corners, from < to */
    int at, back; /* [-] 3 t + k; 1: the triangle passes it from `to` on */
};

static int by_place(const void *a, const void *b)
{
    const struct corner *const p = a, *const q = b;

    for (int k = 0; k < 3; k++)
        if (p->x[k] != q->x[k]) return p->x[k] < q->x[k] ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

static int by_corners(const void *a, const void *b)
{
    const struct edge *const p = a, *const q = b;

    if (p->from != q->from) return p->from < q->from ? -1 : 1;
    if (p->to != q->to) return p->to < q->to ? -1 : 1;
    return (p->at > q->at) - (p->at < q->at);
}

/* number[3 t + k]: the least 3 t + k at the same place. */
static void number_corners(int n, double (*corner)[3][3], int *number)
{
    struct corner *const all = alloc_zeroed(3 * (size_t)n, sizeof *all);

    for (int c = 0; c < 3 * n; c++) {
        memcpy(all[c].x, corner[c / 3][c % 3], sizeof all[c].x);
        all[c].at = c;
    }
    qsort(all, 3 * (size_t)n, sizeof *all, by_place);
    for (int c = 0, same = 0; c < 3 * n; c++) {
        for (int k = 0; k < 3; k++)
            if (all[c].x[k] != all[same].x[k]) same = c;
        number[all[c].at] = all[same].at;
    }
    free(all);
}

/* The two triangles of each edge get the sum of their normals there. NULL, or
 * what is wrong. */
static const char *join_edges(struct closed_surface *s, int n,
                              const int *number)
{
    struct edge *const all = alloc_zeroed(3 * (size_t)n, sizeof *all);
    const char *trouble = NULL;

    for (int e = 0; e < 3 * n; e++) {
        const int a = number[e], b = number[e / 3 * 3 + (e % 3 + 1) % 3];
        all[e] = (struct edge){a < b ? a : b, a < b ? b : a, e, a > b};
    }
    qsort(all, 3 * (size_t)n, sizeof *all, by_corners);
    for (int e = 0; e < 3 * n && trouble == NULL; e += 2) {
        const struct edge *const p = &all[e], *const q = &all[e + 1];
        if (e + 1 == 3 * n || q->from != p->from || q->to != p->to)
            trouble = "an edge belongs to one triangle alone";
        else if (e + 2 < 3 * n && q[1].from == p->from && q[1].to == p->to)
            trouble = "an edge belongs to more than two triangles";
        else if (p->back == q->back)
            trouble = "two triangles with an edge in common turn their "
                      "normals to opposite sides";
        else
            for (int k = 0; k < 3; k++)
                s->edge[p->at / 3][p->at % 3][k] =
                    s->edge[q->at / 3][q->at % 3][k] =
                        s->face[p->at / 3][k] + s->face[q->at / 3][k];
    }
    free(all);
    return trouble;
}

/* Angle of triangle t in its corner k [rad]. */
static double angle_in(const double x[3][3], int k)
{
    double a[3], b[3], c[3];

    vector_between(x[(k + 1) % 3], x[k], a);
    vector_between(x[(k + 2) % 3], x[k], b);
    vector_cross(a, b, c);
    return atan2(vector_length(c), vector_dot(a, b));
}

static void join_points(struct closed_surface *s, int n, const int *number)
{
    for (int c = 0; c < 3 * n; c++) {
        const double(*const x)[3] = (const double(*)[3])s->corner[c / 3];
        const int to = number[c];
        vector_along(s->point[to / 3][to % 3], angle_in(x, c % 3),
                     s->face[c / 3], s->point[to / 3][to % 3]);
    }
    for (int c = 0; c < 3 * n; c++)
        memcpy(s->point[c / 3][c % 3], s->point[number[c] / 3][number[c] % 3],
               sizeof s->point[0][0]);
}

static const char *closed_surface_join(struct closed_surface *s, int n)
{
    int *const number = alloc_ints(3 * n);
    double(*const corner)[3][3] = s->corner;

    number_corners(n, corner, number);
    s->face = owner_zeroed(s, (size_t)n, sizeof *s->face);
    s->edge = owner_zeroed(s, (size_t)n, sizeof *s->edge);
    s->point = owner_zeroed(s, (size_t)n, sizeof *s->point);
    for (int t = 0; t < n; t++)
        triangle_normal((const double(*)[3])corner[t], s->face[t]);
    const char *const trouble = join_edges(s, n, number);
    if (trouble == NULL) join_points(s, n, number);
    free(number);
    return trouble;
}

/* --- the whole ------------------------------------------------------------ */

/* The corners and the box around them, from the centroid. */
static void centre_on_centroid(struct closed_surface *s, int n)
{
    struct body_outline *const o = &s->outline;
    double(*const corner)[3][3] = s->corner;

    closed_surface_set_moments(o, n, corner);
    if (o->volume < 0.0) {
        turn_over(n, corner);
        closed_surface_set_moments(o, n, corner);
    }
    if (!(o->volume > 0.0)) memset(o->centre, 0, sizeof o->centre);
    for (int c = 0; c < 9 * n; c++) {
        double *const x = &corner[c / 9][c / 3 % 3][c % 3];
        *x -= o->centre[c % 3];
        o->half[c % 3] = fmax(o->half[c % 3], fabs(*x));
    }
}

/* The least of its box and of what most of it is thick. */
static void set_width(struct body_outline *o)
{
    const double *const half = o->half;
    const double box = 2.0 * fmin(half[0], fmin(half[1], half[2]));

    o->width = fmin(box, thickness_of(o->n_triangles, o->corner));
}

struct body_outline *closed_surface_create(int n, double (*corner)[3][3],
                                           const char **trouble)
{
    struct closed_surface *const s = owner_create(sizeof *s);

    s->corner = owner_zeroed(s, (size_t)n, sizeof *s->corner);
    memcpy(s->corner, corner, (size_t)n * sizeof *s->corner);
    s->outline.distance = closed_surface_distance;
    s->last = owner_ints(s, 1);
    centre_on_centroid(s, n);
    s->outline.n_triangles = n;
    s->outline.corner = s->corner;
    *trouble = closed_surface_join(s, n);
    if (*trouble == NULL && !(s->outline.volume > 0.0))
        *trouble = "it has no volume";
    if (*trouble == NULL) {
        s->tree = triangle_tree_create(s, n, s->corner);
        set_width(&s->outline);
        return &s->outline;
    }
    owner_free(s);
    return NULL;
}
