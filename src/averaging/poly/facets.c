/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/poly/facets.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

enum { FLAT_MOST = 8 };     /* corners of a facet, see struct piece */
enum { MOST_TURNS = 1000 }; /* a body may be as wide as this many periods */

/* A polygon whose corners are off its plane by less than this fraction of its
 * width counts as flat [-]. */
static const double flat = 1e-12;

/* Twice the area of polygon p, and the mean of its corners. */
static void facets_measure(const struct mesh_shape *s, int p, double S[3],
                           double mean[3])
{
    const int first = s->start[p], n = s->start[p + 1] - first;

    S[0] = S[1] = S[2] = mean[0] = mean[1] = mean[2] = 0.0;
    for (int i = 0; i < n; i++)
        vector_along(mean, 1.0 / n, &s->point[3 * s->corner[first + i]], mean);
    for (int i = 0; i < n; i++) {
        double u[3], v[3], w[3];
        vector_between(&s->point[3 * s->corner[first + i]], mean, u);
        vector_between(&s->point[3 * s->corner[first + (i + 1) % n]], mean, v);
        vector_cross(u, v, w);
        vector_along(S, 1.0, w, S);
    }
}

static int facets_is_flat(const struct mesh_shape *s, int p)
{
    double S[3], mean[3], off = 0.0;

    if (s->start[p + 1] - s->start[p] > FLAT_MOST) return 0;
    facets_measure(s, p, S, mean);
    const double area2 = vector_length(S);
    for (int i = s->start[p]; i < s->start[p + 1]; i++) {
        double d[3];
        vector_between(&s->point[3 * s->corner[i]], mean, d);
        off = fmax(off, fabs(vector_dot(d, S)));
    }
    return off <= flat * area2 * sqrt(area2);
}

/* Facet j of the points a, b, c ...; its normal by the first three, or for a
 * flat polygon by all of them. */
static void set_normal(struct facets *f, int j, const double S[3])
{
    const double size = vector_length(S);

    for (int k = 0; k < 3 && size > 0.0; k++)
        f->normal[3 * j + k] = S[k] / size;
}

/* The polygon as it is, or as triangles around its middle, point `middle`. */
static void facets_add_flat(struct facets *f, int p, int *j, int *at)
{
    const struct mesh_shape *const s = f->mesh->shape;
    double S[3], mean[3];

    facets_measure(s, p, S, mean);
    set_normal(f, *j, S);
    for (int i = s->start[p]; i < s->start[p + 1]; i++)
        f->corner[(*at)++] = s->corner[i];
    f->start[++*j] = *at;
}

static void add_bent(struct facets *f, int p, int middle, int *j, int *at)
{
    const struct mesh_shape *const s = f->mesh->shape;
    const int first = s->start[p], n = s->start[p + 1] - first;
    double S[3], *const x = &f->point[3 * middle];

    facets_measure(s, p, S, x);
    for (int i = 0; i < n; i++) {
        const int a = s->corner[first + i], b = s->corner[first + (i + 1) % n];
        double u[3], v[3];
        vector_between(&f->point[3 * a], x, u);
        vector_between(&f->point[3 * b], x, v);
        vector_cross(u, v, S);
        set_normal(f, *j, S);
        f->corner[(*at)++] = a;
        f->corner[(*at)++] = b;
        f->corner[(*at)++] = middle;
        f->start[++*j] = *at;
    }
}

static void divide_polygons(struct facets *f)
{
    const struct mesh_shape *const s = f->mesh->shape;
    const int corners = s->start[s->n_polygons];
    int bent = 0, j = 0, at = 0;

    for (int p = 0; p < s->n_polygons; p++)
        bent += !facets_is_flat(s, p);
    f->point = owner_doubles(f, 3 * (s->n_points + bent));
    memcpy(f->point, s->point, 3 * (size_t)s->n_points * sizeof *f->point);
    f->of = owner_ints(f, s->n_polygons + 1);
    f->normal = owner_doubles(f, 3 * corners); /* a facet a corner at most */
    f->start = owner_ints(f, corners + 1);
    f->corner = owner_ints(f, 3 * corners);
    for (int p = 0, middle = s->n_points; p < s->n_polygons; p++) {
        if (facets_is_flat(s, p))
            facets_add_flat(f, p, &j, &at);
        else
            add_bent(f, p, middle++, &j, &at);
        f->of[p + 1] = j;
    }
}

/* The ends and the volume of cell c. */
static void measure_cell(struct facets *f, int c)
{
    const struct mesh_shape *const s = f->mesh->shape;
    double *const lo = &f->lo[3 * c], *const hi = &f->hi[3 * c];

    for (int k = 0; k < 3; k++) {
        lo[k] = INFINITY;
        hi[k] = -INFINITY;
    }
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++) {
        const int p = s->polygon[i];
        for (int a = f->start[f->of[p]]; a < f->start[f->of[p + 1]]; a++)
            for (int k = 0; k < 3; k++) {
                const double x = f->point[3 * f->corner[a] + k];
                lo[k] = fmin(lo[k], x);
                hi[k] = fmax(hi[k], x);
            }
    }
    f->V[c] = facets_in_box(f, c, lo, hi);
}

/* The mean corner of polygon p. */
static void middle_of(const struct mesh_shape *s, int p, double x[3])
{
    double S[3];
    facets_measure(s, p, S, x);
}

/* The periods at which cell c has a polygon on either side. */
static int ring_of(const struct mesh *m, int c)
{
    const struct mesh_shape *const s = m->shape;
    int ring = 0;

    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
        for (int j = s->cell_start[c]; j < s->cell_start[c + 1]; j++) {
            double a[3], b[3], d[3], rest[3];
            middle_of(s, s->polygon[i], a);
            middle_of(s, s->polygon[j], b);
            vector_between(b, a, d);
            for (int k = 0; k < m->n_periods; k++) {
                vector_between(d, m->period[k], rest);
                if (vector_length(rest) < 1e-6 * vector_length(m->period[k]))
                    ring |= 1 << k;
            }
        }
    return ring;
}

struct facets *facets_create(const struct mesh *m)
{
    struct facets *const f = owner_create(sizeof *f);
    int any = 0;

    f->mesh = m;
    f->lo = owner_doubles(f, 3 * m->n_cells);
    f->hi = owner_doubles(f, 3 * m->n_cells);
    f->V = owner_doubles(f, m->n_cells);
    divide_polygons(f);
    for (int c = 0; c < m->n_cells; c++)
        measure_cell(f, c);
    if (m->n_periods > 0) f->ring = owner_ints(f, m->n_cells);
    for (int c = 0; c < m->n_cells && m->n_periods > 0; c++)
        any |= f->ring[c] = ring_of(m, c);
    if (!any) f->ring = NULL;
    return f;
}

int facets_contain(const struct facets *f, enum facets_body body, int c,
                   const double from[3], double R)
{
    const struct mesh_shape *const s = f->mesh->shape;
    double o[3];

    vector_along(&f->mesh->centre[3 * c], 1.0, from, o);
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
        for (int j = f->of[s->polygon[i]]; j < f->of[s->polygon[i] + 1]; j++) {
            const double *const n = &f->normal[3 * j];
            const double *const x = &f->point[3 * f->corner[f->start[j]]];
            const double d[3] = {x[0] - o[0], x[1] - o[1], x[2] - o[2]};
            const double reach = body == FACETS_SPHERE
                                     ? 1.0
                                     : fabs(n[0]) + fabs(n[1]) + fabs(n[2]);
            if (s->turned[i] * vector_dot(d, n) < R * reach) return 0;
        }
    return 1;
}

/* With the centre of the body at o. */
static double overlap_at(const struct facets *f, enum facets_body body, int c,
                         const double o[3], double R)
{
    if (body == FACETS_SPHERE) return facets_in_sphere(f, c, o, R);
    const double lo[3] = {o[0] - R, o[1] - R, o[2] - R};
    const double hi[3] = {o[0] + R, o[1] + R, o[2] + R};
    return facets_in_box(f, c, lo, hi);
}

double facets_overlap(const struct facets *f, enum facets_body body, int c,
                      const double from[3], double R)
{
    const struct mesh *const m = f->mesh;
    int turns[3] = {0, 0, 0};
    double o[3], sum = 0.0;

    vector_along(&m->centre[3 * c], 1.0, from, o);
    if (f->ring == NULL) return overlap_at(f, body, c, o, R);
    for (int k = 0; k < m->n_periods; k++)
        if (f->ring[c] >> k & 1)
            turns[k] = 1 + number_clamped(2.0 * R / vector_length(m->period[k]),
                                          0, MOST_TURNS);
    for (int i = -turns[0]; i <= turns[0]; i++)
        for (int j = -turns[1]; j <= turns[1]; j++)
            for (int l = -turns[2]; l <= turns[2]; l++) {
                double x[3];
                vector_along(o, i, m->period[0], x);
                vector_along(x, j, m->period[1], x);
                vector_along(x, l, m->period[2], x);
                sum += overlap_at(f, body, c, x, R);
            }
    return sum;
}

/* The volume of a box in a cell.
 *
 * The field F = (min(x, hi) - lo, 0, 0) between the four planes that bound the
 * box in y and z, from x = lo on, has the divergence 1 in the box and 0
 * elsewhere, and no flux through the planes where it ends. The volume is
 * therefore the flux of F through the facets: each facet is cut by five planes,
 * and the remaining part is divided at x = hi. */

/* A facet has at most 8 corners, and a cut leaves at most half as many again:
 * 8 (3/2)^6. */
enum { CORNERS = 96 };

struct piece {
    int n;
    double x[CORNERS][3]; /* [m] */
};

/* Cuts off the part of the piece on the other side of the plane x[k] = at;
 * `sign` gives the side that is kept. */
static void facets_box_cut(struct piece *p, int k, double at, double sign)
{
    struct piece q;

    q.n = 0;
    for (int i = 0; i < p->n; i++) {
        const double *const a = p->x[i], *const b = p->x[(i + 1) % p->n];
        const double da = sign * (a[k] - at), db = sign * (b[k] - at);
        if (da >= 0.0) memcpy(q.x[q.n++], a, 3 * sizeof *a);
        if (!((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0))) continue;
        for (int l = 0; l < 3; l++)
            q.x[q.n][l] = a[l] + da / (da - db) * (b[l] - a[l]);
        q.x[q.n++][k] = at;
    }
    p->n = q.n;
    memcpy(p->x, q.x, (size_t)q.n * sizeof *q.x);
}

/* The integral of (x - lo) dy dz over the piece, or with `width` of width dy
 * dz; positive where its normal has a positive x. */
static double flux(const struct piece *p, double lo, double width)
{
    double sum = 0.0;

    for (int i = 1; i + 1 < p->n; i++) {
        const double *const a = p->x[0], *const b = p->x[i],
                            *const c = p->x[i + 1];
        const double area = 0.5 * ((b[1] - a[1]) * (c[2] - a[2]) -
                                   (b[2] - a[2]) * (c[1] - a[1]));
        sum += area * (width > 0.0 ? width : (a[0] + b[0] + c[0]) / 3.0 - lo);
    }
    return sum;
}

static double facets_box_facet(const struct facets *f, int j,
                               const double lo[3], const double hi[3])
{
    struct piece p, q;

    p.n = 0;
    for (int i = f->start[j]; i < f->start[j + 1]; i++)
        memcpy(p.x[p.n++], &f->point[3 * f->corner[i]], sizeof p.x[0]);
    for (int k = 0; k < 3; k++) {
        facets_box_cut(&p, k, lo[k], 1.0);
        if (k > 0) facets_box_cut(&p, k, hi[k], -1.0);
    }
    double far = -INFINITY;
    for (int i = 0; i < p.n; i++)
        far = fmax(far, p.x[i][0]);
    if (far <= hi[0]) return flux(&p, lo[0], 0.0);
    q = p;
    facets_box_cut(&p, 0, hi[0], -1.0);
    facets_box_cut(&q, 0, hi[0], 1.0);
    return flux(&p, lo[0], 0.0) + flux(&q, lo[0], hi[0] - lo[0]);
}

double facets_in_box(const struct facets *f, int c, const double lo[3],
                     const double hi[3])
{
    const struct mesh_shape *const s = f->mesh->shape;
    double all = 1.0, V = 0.0;

    for (int k = 0; k < 3; k++) {
        all *= hi[k] - lo[k];
        if (f->lo[3 * c + k] >= hi[k] || f->hi[3 * c + k] <= lo[k]) return 0.0;
    }
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
        for (int j = f->of[s->polygon[i]]; j < f->of[s->polygon[i] + 1]; j++)
            V += s->turned[i] * facets_box_facet(f, j, lo, hi);
    return V > 1e-14 * all ? V : 0.0; /* less is rounding around nothing */
}

/* The volume of a ball in a cell.
 *
 * The field F = (x / 3) min(1, (R / r)^3), with the centre as origin, is
 * continuous; its divergence is 1 in the ball and 0 outside. So the volume is
 * the flux of F through the facets. On the plane of a facet, in polar
 * coordinates about the foot of the centre, the flux through the triangle from
 * the foot to an edge is a sum of closed terms over the parts of the edge in
 * the ball and outside; with the triangles of all edges it is that of the
 * facet, convex or not. */

/* Volumes below this fraction of R^3 are rounding errors [-]. */
static const double nothing = 1e-14;

/* The plane of a facet relative to the ball. */
struct plane {
    double h; /* [m] from the centre to the plane, along its normal */
    double R; /* [m] */
    double K; /* [m^3] flux per radian of the part outside, without its curved
                 part */
};

/* From t1 to t2 along an edge that passes the foot at the distance g [m], all
 * of it outside of the ball. */
static double facets_sphere_beyond(const struct plane *p, double g, double t1,
                                   double t2)
{
    const double h2 = p->h * p->h, g2 = g * g;
    const double r1 = sqrt(h2 + g2 + t1 * t1), r2 = sqrt(h2 + g2 + t2 * t2);
    const double angle = atan2(g * (t2 - t1), g2 + t1 * t2);
    const double bend =
        atan2(g * p->h * (r1 * t2 - r2 * t1), g2 * r1 * r2 + h2 * t1 * t2);

    return p->K * angle - p->R * p->R * p->R / 3.0 * bend;
}

/* The flux through the triangle from the foot to the edge. */
static double triangle(const struct plane *p, double g, double t1, double t2)
{
    const double s2 = p->R * p->R - p->h * p->h - g * g;

    if (s2 <= 0.0) return facets_sphere_beyond(p, g, t1, t2);
    const double s = sqrt(s2); /* the edge is in the ball from -s to s */
    const double in1 = fmax(-s, fmin(s, t1)), in2 = fmax(-s, fmin(s, t2));
    double sum = p->h * g * (in2 - in1) / 6.0;
    if (t1 < -s) sum += facets_sphere_beyond(p, g, t1, fmin(t2, -s));
    if (t2 > s) sum += facets_sphere_beyond(p, g, fmax(t1, s), t2);
    return sum;
}

/* The flux through facet j (21.2). */
static double facets_sphere_facet(const struct facets *f, int j,
                                  const double o[3], double R)
{
    const double *const n = &f->normal[3 * j];
    const int first = f->start[j], count = f->start[j + 1] - first;
    const double *before = &f->point[3 * f->corner[first + count - 1]];
    double a[3], sum = 0.0;

    vector_between(before, o, a);
    const double h = vector_dot(a, n);
    const double K = fabs(h) < R ? h * (3.0 * R * R - h * h) / 6.0
                                 : copysign(R * R * R / 3.0, h);
    const struct plane p = {h, R, K};
    for (int i = 0; i < count; i++) {
        const double *const here = &f->point[3 * f->corner[first + i]];
        double e[3], side[3];
        vector_between(here, before, e);
        vector_cross(e, n, side); /* out of the facet */
        const double length = vector_length(e);
        if (length > 0.0) {
            const double t = vector_dot(a, e) / length;
            sum += triangle(&p, vector_dot(a, side) / length, t, t + length);
        }
        vector_between(here, o, a);
        before = here;
    }
    return sum;
}

double facets_in_sphere(const struct facets *f, int c, const double o[3],
                        double R)
{
    const struct mesh_shape *const s = f->mesh->shape;
    double nearest = 0.0, farthest = 0.0, V = 0.0;

    for (int k = 0; k < 3; k++) {
        const double lo = f->lo[3 * c + k] - o[k], hi = f->hi[3 * c + k] - o[k];
        const double beside = fmax(0.0, fmax(lo, -hi));
        const double end = fmax(-lo, hi);
        nearest += beside * beside;
        farthest += end * end;
    }
    if (nearest >= R * R) return 0.0;
    if (farthest <= R * R) return f->V[c];
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
        for (int j = f->of[s->polygon[i]]; j < f->of[s->polygon[i] + 1]; j++)
            V += s->turned[i] * facets_sphere_facet(f, j, o, R);
    return V > nothing * R * R * R ? V : 0.0;
}
