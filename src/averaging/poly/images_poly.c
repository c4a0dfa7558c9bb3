/* SPDX-License-Identifier: GPL-3.0-or-later */
/* images_poly.c -- a Gaussian with mirror images on cells of any shape.
 *
 * Chapter "Further averaging methods".
 *
 *     w_ic = sum over c and its images of
 *         V_c N(x_i - x_c; b^2 / 2 + M_c) over the sum of that      (21.6)
 *
 * N is the normal density of that covariance and M_c that of the cell itself,
 * the mean of r r^T over it (gaussian_moments.h). The images themselves are
 * described in wall_images.h.
 *
 * Near flat walls the field of a uniform bed is then uniform. Near other walls
 * the heights of the cells are scaled until it is: each cell has one height,
 * and the weights of each particle still add up to one.
 */
#include <math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/kernel/weights.h"
#include "averaging/poly/gaussian_moments.h"
#include "base/alloc.h"
#include "base/vector.h"

static const double images_reach = 3.0; /* [-] of b, as in images.c */

/* The iteration stops when the largest correction is below this; the next one
 * would be several times smaller. */
static const double even = 5e-3; /* [-] */
enum { ROUNDS = 8 };

struct images_poly {
    const struct cell_of_particle *h; /* borrowed */
    struct weights *weights;
    struct gaussian_moments *normals;
};

/* The weights of a particle at the offset o from the centre of the cell. */
static int weights_at(const struct images_poly *s, const double o[3],
                      const struct neighbourhood *near, double *restrict w)
{
    const struct gaussian_moments *const N = s->normals;
    double sum = 0.0;

    for (int e = 0; e < near->n; e++) {
        const int c = near->cell + near->index_offset[e];
        const double r[3] = {o[0] - near->dx[e], o[1] - near->dy[e],
                             o[2] - near->dz[e]};
        w[e] = 0.0;
        for (int k = N->start[c]; k < N->start[c + 1]; k++)
            w[e] += gaussian_moments_value(&N->moment[k], r);
        sum += w[e];
    }
    if (!(sum > 0.0)) return 0;
    for (int e = 0; e < near->n; e++)
        w[e] /= sum; /* over the cells of one particle, as (8.7) */
    return 1;
}

static int images_weights(const void *state, int i,
                          const struct neighbourhood *near, double *w)
{
    const struct images_poly *const s = state;
    return weights_at(s, &s->h->offset[3 * i], near, w);
}

/* Spreads a uniform bed with solid fraction 1 to all cells [m^3]. In each cell
 * there are six particles, two in each direction, with the volume and moments
 * of the cell. */
static void spread_even(const struct images_poly *s, double *got, double *w)
{
    const struct mesh *const m = s->h->mesh;

    for (int c = 0; c < m->n_cells; c++)
        got[c] = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        const struct neighbourhood near = weights_around(s->weights, c);
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
                got[c + near.index_offset[e]] += m->V[c] / 6.0 * w[e];
        }
    }
}

/* The weights should also add up to one for each cell [EW18 18], so that a
 * uniform bed gives a uniform field. With flat walls they do. For other walls
 * the heights are scaled iteratively, while the weights of each particle are
 * normalised over its cells. */
static void make_even(struct images_poly *s)
{
    const struct mesh *const m = s->h->mesh;
    struct gaussian_moments *const N = s->normals;
    double *const got = alloc_doubles(m->n_cells);
    double *const w = alloc_doubles(weights_stencil(s->weights)->largest);
    double worst = INFINITY;

    for (int round = 0; round < ROUNDS && worst > even; round++) {
        worst = 0.0;
        spread_even(s, got, w);
        for (int c = 0; c < m->n_cells; c++) {
            if (!(got[c] > 0.0)) continue;
            const double scale = m->V[c] / got[c];
            worst = fmax(worst, fabs(scale - 1.0));
            for (int k = N->start[c]; k < N->start[c + 1]; k++)
                N->moment[k].height *= scale;
        }
    }
    free(got);
    free(w);
}

static void *images_poly_create(const struct cell_of_particle *h,
                                const struct averaging_options *o)
{
    struct images_poly *const s = alloc_zeroed(1, sizeof *s);
    const double reach = images_reach * o->bandwidth;
    struct facets *const f = facets_create(h->mesh);
    struct wall_images *const m = wall_images_create(f, reach);

    s->h = h;
    s->normals = gaussian_moments_create(f, m, o->bandwidth);
    s->weights = weights_create(h, reach, STENCIL_TO_CENTRE, o->fields,
                                (struct weights_rule){images_weights, s, NULL});
    make_even(s);
    wall_images_free(m);
    facets_free(f);
    return s;
}

static void images_poly_free(void *state)
{
    struct images_poly *const s = state;

    weights_free(s->weights);
    gaussian_moments_free(s->normals);
    free(s);
}

static void images_poly_spread(void *state, int m, const double *q,
                               double *field, struct averaging_report *r)
{
    const struct images_poly *const s = state;
    r->unsupported = weights_spread(s->weights, m, q, field);
}

static void images_poly_gather(void *state, int m, const double *field,
                               double *q, struct averaging_report *r)
{
    const struct images_poly *const s = state;

    (void)r;
    weights_gather(s->weights, m, field, q);
}

const struct averaging_method images_poly_method = {
    .name = "images",
    .what = "a Gaussian kernel with mirror images at walls",
    .equations = "EW18 17-21",
    .function = "images_weights",
    .needs_bandwidth = 1,
    .reach_b = 3.0,
    .create = images_poly_create,
    .free = images_poly_free,
    .spread = images_poly_spread,
    .gather = images_poly_gather,
};
