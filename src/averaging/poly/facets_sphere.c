/* SPDX-License-Identifier: GPL-3.0-or-later */
/* facets_sphere.c -- the volume of a ball in a cell.
 *
 * The field F = (x / 3) min(1, (R / r)^3), with the centre as origin, is
 * continuous; its divergence is 1 in the ball and 0 outside. So the volume is
 * the flux of F through the facets. On the plane of a facet, in polar
 * coordinates about the foot of the centre, the flux through the triangle from
 * the foot to an edge is a sum of closed terms over the parts of the edge in
 * the ball and outside; with the triangles of all edges it is that of the
 * facet, convex or not.
 */
#include "averaging/poly/facets.h"

#include <math.h>

#include "base/vector.h"

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
