/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In a box the Gaussian is a product of three, one a direction. A particle's
 * share of each slab of cells is found once for each direction, images
 * included; the share of a cell is a product of three numbers.
 */
#include "averaging/images.h"

#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/shares.h"
#include "base/alloc.h"

static const double images_reach = 3.0; /* [-] of b */

struct images {
    const struct hosts *h; /* borrowed */
    struct shares *shares;
    double b; /* [m] */
    int *at;  /* [-] for each entry of the stencil, how many cells it is from
                 the host in each direction, round the period */
    int far;  /* [-] the largest of them, without its sign */
};

double images_sigma(double delta_05)
{
    return delta_05 / (2.0 * sqrt(2.0 * log(2.0))); /* [EW18 20] */
}

double images_bandwidth(double delta_05)
{
    return sqrt(2.0) * images_sigma(delta_05);
}

double images_kernel(double r, double sigma)
{
    const double s = sigma * sqrt(2.0 * M_PI);
    return exp(-r * r / (2.0 * sigma * sigma)) / (s * s * s); /* [EW18 19] */
}

/* Edge j of direction k, counted on round the period. */
static double edge(const struct box *b, int k, int j)
{
    const int n = b->n[k];
    const int turns = j >= 0 ? j / n : -((n - 1 - j) / n);
    const double L = b->edge[k][n] - b->edge[k][0];

    if (!b->periodic[k]) return b->edge[k][j];
    return b->edge[k][j - turns * n] + turns * L;
}

/* What of a Gaussian around x is between lo and hi. */
static double part(double x, double lo, double hi, double b)
{
    return 0.5 * (erf((hi - x) / b) - erf((lo - x) / b));
}

/* The same with all images of x in two walls [EW18 21], as far as they
 * matter. Every second one is a mirror image. */
static double part_between_walls(double x, double lo, double hi, double b,
                                 double wall, double L)
{
    const int turns = (int)ceil(0.5 * (images_reach + 1.0) * b / L);
    double sum = 0.0;

    for (int t = -turns; t <= turns; t++) {
        const double there = x + 2.0 * t * L;
        const double mirrored = 2.0 * wall - x + 2.0 * t * L;
        sum += part(there, lo, hi, b) + part(mirrored, lo, hi, b);
    }
    return sum;
}

/* Shares of the slabs -far .. far from the host's, number `mine`, in direction
 * k, of a particle at x. */
static void share_slabs(const struct images *s, int k, int mine, double x,
                        double *share)
{
    const struct box *const b = &s->h->mesh->box;
    const double wall = b->edge[k][0], L = b->edge[k][b->n[k]] - wall;
    const int alone = b->n[k] == 1;

    for (int e = -s->far; e <= s->far; e++) {
        const int j = mine + e;
        share[e + s->far] = 0.0;
        if (!b->periodic[k] && (j < 0 || j >= b->n[k])) continue;
        if (alone && e != 0) continue;
        const double lo = edge(b, k, j), hi = edge(b, k, j + 1);
        share[e + s->far] = alone ? 1.0
                            : b->periodic[k]
                                ? part(x, lo, hi, s->b)
                                : part_between_walls(x, lo, hi, s->b, wall, L);
    }
}

/* The weights of both directions [EW18 17, 18]: products of slabs' shares. */
static int images_weights(const void *state, int i, const struct around *near,
                          double *w)
{
    const struct images *const s = state;
    const struct mesh *const m = s->h->mesh;
    const int *const at = &s->at[3 * near->first];
    const int c = near->host, nx = m->box.n[0], ny = m->box.n[1];
    const int mine[3] = {c % nx, c / nx % ny, c / nx / ny};
    const int wide = 2 * s->far + 1, far = s->far;
    double share[3 * wide]; /* some dozen numbers */
    double sum = 0.0;

    for (int k = 0; k < 3; k++)
        share_slabs(s, k, mine[k],
                    m->centre[3 * c + k] + s->h->offset[3 * i + k],
                    &share[k * wide]);
    for (int e = 0; e < near->n; e++) {
        w[e] = share[at[3 * e] + far] * share[wide + at[3 * e + 1] + far] *
               share[2 * wide + at[3 * e + 2] + far];
        sum += w[e];
    }
    for (int e = 0; e < near->n; e++)
        w[e] /= sum; /* not 0: the centre is in the host */
    return 1;
}

/* Which slab, counted from the host's, has the distance d between centres. The
 * nearest one: no two are alike. */
static int slabs_off(const struct box *b, int k, int mine, double d)
{
    const double x = 0.5 * (edge(b, k, mine) + edge(b, k, mine + 1)) + d;
    const int step = d < 0.0 ? -1 : 1;
    int j = mine;

    if (b->n[k] == 1) return 0;
    while (b->periodic[k] || (j + step >= 0 && j + step < b->n[k])) {
        const double lo = edge(b, k, j), hi = edge(b, k, j + 1);
        if (x >= lo && x <= hi) break;
        j += step;
    }
    return j - mine;
}

/* For a shape one host is as good as any. */
static void locate_entries(struct images *s)
{
    const struct stencil *const near = shares_stencil(s->shares);
    const struct box *const b = &s->h->mesh->box;
    int seen = 0; /* shapes are numbered as they are met */

    s->at = alloc_ints(3 * near->start[near->n_shapes]);
    for (int c = 0; c < s->h->mesh->n_cells && seen < near->n_shapes; c++) {
        const int mine[3] = {c % b->n[0], c / b->n[0] % b->n[1],
                             c / b->n[0] / b->n[1]};
        if (near->shape[c] != seen) continue;
        for (int e = near->start[seen]; e < near->start[seen + 1]; e++) {
            const double d[3] = {near->dx[e], near->dy[e], near->dz[e]};
            for (int k = 0; k < 3; k++) {
                s->at[3 * e + k] = slabs_off(b, k, mine[k], d[k]);
                s->far = GSL_MAX_INT(s->far, abs(s->at[3 * e + k]));
            }
        }
        seen++;
    }
}

static void *images_create(const struct hosts *h,
                           const struct averaging_options *o)
{
    if (h->mesh->box.n[0] == 0) {
        fprintf(stderr, "winnow: the averaging by images needs a mesh that is "
                        "a box; \"gaussian\" and \"diffusion\" do not\n");
        return NULL;
    }
    struct images *const s = alloc_zeroed(1, sizeof *s);

    s->h = h;
    s->b = o->bandwidth;
    s->shares =
        shares_create(h, images_reach * s->b, STENCIL_TO_CELL, o->fields,
                      (struct shares_rule){images_weights, s, 0});
    locate_entries(s);
    return s;
}

static void images_free(void *state)
{
    struct images *const s = state;

    shares_free(s->shares);
    free(s->at);
    free(s);
}

static void images_spread(void *state, int m, const double *q, double *field,
                          struct averaging_report *r)
{
    const struct images *const s = state;
    r->alone = shares_spread(s->shares, m, q, field);
}

static void images_gather(void *state, int m, const double *field, double *q,
                          struct averaging_report *r)
{
    const struct images *const s = state;

    (void)r;
    shares_gather(s->shares, m, field, q);
}

const struct averaging_method images_method = {
    .name = "images",
    .cite = "EW18 17-21",
    .what = "a Gaussian weight, with mirror images at walls",
    .function = "images_weights",
    .wide = 1,
    .create = images_create,
    .free = images_free,
    .spread = images_spread,
    .gather = images_gather,
};
