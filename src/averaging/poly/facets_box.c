/* SPDX-License-Identifier: GPL-3.0-or-later */
/* facets_box.c -- the volume of a box in a cell.
 *
 * The field F = (min(x, hi) - lo, 0, 0) between the four planes that bound the
 * box in y and z, from x = lo on, has the divergence 1 in the box and 0
 * elsewhere, and no flux through the planes where it ends. The volume is
 * therefore the flux of F through the facets: each facet is cut by five planes,
 * and the remaining part is divided at x = hi.
 */
#include "averaging/poly/facets.h"

#include <math.h>
#include <string.h>

/* A facet has at most 8 corners, and a cut leaves at most half as many again:
 * 8 (3/2)^6. */
enum { CORNERS = 96 };

struct piece {
    int n;
    double x[CORNERS][3]; /* [m] */
};

/* Cuts off the part of the piece on the other side of the plane x[k] = at;
 * `sign` gives the side that is kept.
 */
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
