/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/dpvm.h"

#include <math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/overlap.h"
#include "averaging/shares.h"
#include "base/alloc.h"

struct dpvm {
    const struct hosts *h; /* borrowed */
    struct shares *shares;
    double *half; /* [m] half extents of the cells, 3; infinite where a period
                     is one cell wide, which then has all of the body */
    double (*overlap)(double R, const double lo[3], const double hi[3]);
    double corner; /* [-] of R: the farthest point of the body */
};

/* 1 if the body is wholly within its host, as most are where cells are large.
 * A sphere and its cube reach equally far in each direction. */
static int is_within(const double o[3], double R, const double half[3])
{
    return fabs(o[0]) + R <= half[0] && fabs(o[1]) + R <= half[1] &&
           fabs(o[2]) + R <= half[2];
}

static int dpvm_weights(const void *state, int i, const struct around *near,
                        double *w)
{
    const struct dpvm *const d = state;
    const double R = 0.5 * d->h->ps->d[i], *const o = &d->h->offset[3 * i];
    double sum = 0.0;

    if (is_within(o, R, &d->half[3 * near->host])) return 0;
    for (int e = 0; e < near->n; e++) {
        const double *const half = &d->half[3 * (near->host + near->step[e])];
        const double x = near->dx[e] - o[0], y = near->dy[e] - o[1],
                     z = near->dz[e] - o[2];
        const double lo[3] = {x - half[0], y - half[1], z - half[2]};
        const double hi[3] = {x + half[0], y + half[1], z + half[2]};
        w[e] = d->overlap(R, lo, hi);
        sum += w[e];
    }
    for (int e = 0; e < near->n; e++)
        w[e] /= sum; /* not 0: the centre is in the host */
    return 1;
}

/* Of the largest body [m]. */
static double reach(const struct dpvm *d)
{
    const struct particles *const ps = d->h->ps;
    double R = 0.0;

    for (int i = 0; i < ps->n; i++)
        R = fmax(R, 0.5 * ps->d[i]);
    return d->corner * R;
}

static void *create(const struct hosts *h, const struct averaging_options *o,
                    double (*overlap)(double, const double *, const double *),
                    double corner)
{
    const struct box *const box = &h->mesh->box;
    struct dpvm *const d = alloc_zeroed(1, sizeof *d);

    d->h = h;
    d->overlap = overlap;
    d->corner = corner;
    d->half = stencil_extents(h->mesh);
    for (int c = 0; c < h->mesh->n_cells; c++)
        for (int k = 0; k < 3; k++)
            if (box->periodic[k] && box->n[k] == 1)
                d->half[3 * c + k] = INFINITY;
    d->shares = shares_create(h, reach(d), STENCIL_TO_CELL, o->fields,
                              (struct shares_rule){dpvm_weights, d, 1});
    return d;
}

static void *dpvm_create(const struct hosts *h,
                         const struct averaging_options *o)
{
    return create(h, o, overlap_sphere, 1.0);
}

static void *cube_create(const struct hosts *h,
                         const struct averaging_options *o)
{
    return create(h, o, overlap_cube, sqrt(3.0));
}

static void dpvm_free(void *state)
{
    struct dpvm *const d = state;

    shares_free(d->shares);
    free(d->half);
    free(d);
}

/* A larger particle than all before may have come. */
static void dpvm_bind(void *state, struct averaging_report *r)
{
    struct dpvm *const d = state;

    (void)r;
    shares_extend(d->shares, reach(d));
    shares_bind(d->shares);
}

static void dpvm_spread(void *state, int m, const double *q, double *field,
                        struct averaging_report *r)
{
    const struct dpvm *const d = state;
    r->alone = shares_spread(d->shares, m, q, field);
}

static void dpvm_gather(void *state, int m, const double *field, double *q,
                        struct averaging_report *r)
{
    const struct dpvm *const d = state;

    (void)r;
    shares_gather(d->shares, m, field, q);
}

const struct averaging_method dpvm_method = {
    .name = "dpvm",
    .cite = "SX15 section 1, LS section 5.4",
    .what = "a cell takes the parts of particles in it",
    .function = "dpvm_weights",
    .create = dpvm_create,
    .free = dpvm_free,
    .bind = dpvm_bind,
    .spread = dpvm_spread,
    .gather = dpvm_gather,
};

const struct averaging_method dpvm_cube_method = {
    .name = "cube",
    .cite = "EW18 section 2.4",
    .what = "a cell takes the parts of the particles' cubes in it",
    .function = "dpvm_weights",
    .create = cube_create,
    .free = dpvm_free,
    .bind = dpvm_bind,
    .spread = dpvm_spread,
    .gather = dpvm_gather,
};
