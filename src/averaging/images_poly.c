/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/images_poly.h"

#include <math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/normals.h"
#include "averaging/shares.h"
#include "base/alloc.h"
#include "base/vector.h"

static const double images_reach = 3.0; /* [-] of b, as in images.c */

/* A round that had to scale by less was the last: the next would have to by a
 * few times less. */
static const double even = 5e-3; /* [-] */
enum { ROUNDS = 8 };

struct images_poly {
    const struct hosts *h; /* borrowed */
    struct shares *shares;
    struct normals *normals;
};

/* The weights of a particle at the offset o from the centre of the host. */
static int weights_at(const struct images_poly *s, const double o[3],
                      const struct around *near, double *restrict w)
{
    const struct normals *const N = s->normals;
    double sum = 0.0;

    for (int e = 0; e < near->n; e++) {
        const int c = near->host + near->step[e];
        const double r[3] = {o[0] - near->dx[e], o[1] - near->dy[e],
                             o[2] - near->dz[e]};
        w[e] = 0.0;
        for (int k = N->start[c]; k < N->start[c + 1]; k++)
            w[e] += normals_value(&N->normal[k], r);
        sum += w[e];
    }
    if (!(sum > 0.0)) return 0;
    for (int e = 0; e < near->n; e++)
        w[e] /= sum; /* over the cells of one particle, as (8.7) */
    return 1;
}

static int images_weights(const void *state, int i, const struct around *near,
                          double *w)
{
    const struct images_poly *const s = state;
    return weights_at(s, &s->h->offset[3 * i], near, w);
}

/* What all cells get of a bed that has 1 in each [m^3]. In each host there are
 * six particles, two in each direction, with its volume and moments. */
static void spread_even(const struct images_poly *s, double *got, double *w)
{
    const struct mesh *const m = s->h->mesh;

    for (int c = 0; c < m->n_cells; c++)
        got[c] = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        const struct around near = shares_around(s->shares, c);
        for (int k = 0; k < 6; k++) {
            const double nowhere[3] = {0.0, 0.0, 0.0};
            double o[3];
            vector_along(nowhere, k % 2 == 0 ? sqrt(3.0) : -sqrt(3.0),
                         &s->normals->spread[9 * c + 3 * (k / 2)], o);
            if (!weights_at(s, o, &near, w)) {
                got[c] += m->V[c] / 6.0;
                continue;
            }
            for (int e = 0; e < near.n; e++)
                got[c + near.step[e]] += m->V[c] / 6.0 * w[e];
        }
    }
}

/* Around a cell, too, the weights are to add up to one [EW18 18]: an even bed
 * is to be even. Flat walls see to that. For others the heights are scaled to
 * it, while each particle scales to one over its cells. */
static void make_even(struct images_poly *s)
{
    const struct mesh *const m = s->h->mesh;
    struct normals *const N = s->normals;
    double *const got = alloc_doubles(m->n_cells);
    double *const w = alloc_doubles(shares_stencil(s->shares)->largest);
    double worst = INFINITY;

    for (int round = 0; round < ROUNDS && worst > even; round++) {
        worst = 0.0;
        spread_even(s, got, w);
        for (int c = 0; c < m->n_cells; c++) {
            if (!(got[c] > 0.0)) continue;
            const double scale = m->V[c] / got[c];
            worst = fmax(worst, fabs(scale - 1.0));
            for (int k = N->start[c]; k < N->start[c + 1]; k++)
                N->normal[k].height *= scale;
        }
    }
    free(got);
    free(w);
}

static void *images_poly_create(const struct hosts *h,
                                const struct averaging_options *o)
{
    struct images_poly *const s = alloc_zeroed(1, sizeof *s);
    const double reach = images_reach * o->bandwidth;
    struct facets *const f = facets_create(h->mesh);
    struct mirrors *const m = mirrors_create(f, reach);

    s->h = h;
    s->normals = normals_create(f, m, o->bandwidth);
    s->shares = shares_create(h, reach, STENCIL_TO_CENTRE, o->fields,
                              (struct shares_rule){images_weights, s, 0});
    make_even(s);
    mirrors_free(m);
    facets_free(f);
    return s;
}

static void images_poly_free(void *state)
{
    struct images_poly *const s = state;

    shares_free(s->shares);
    normals_free(s->normals);
    free(s);
}

static void images_poly_spread(void *state, int m, const double *q,
                               double *field, struct averaging_report *r)
{
    const struct images_poly *const s = state;
    r->alone = shares_spread(s->shares, m, q, field);
}

static void images_poly_gather(void *state, int m, const double *field,
                               double *q, struct averaging_report *r)
{
    const struct images_poly *const s = state;

    (void)r;
    shares_gather(s->shares, m, field, q);
}

const struct averaging_method images_poly_method = {
    .name = "images",
    .cite = "EW18 17-21",
    .what = "a Gaussian weight, with mirror images at walls",
    .function = "images_weights",
    .wide = 1,
    .reach_b = 3.0,
    .create = images_poly_create,
    .free = images_poly_free,
    .spread = images_poly_spread,
    .gather = images_poly_gather,
};
