/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/kernel/kernel.h"

#include <math.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "averaging/kernel/weights.h"
#include "base/alloc.h"

/* Cut-off of the Gaussian, over b: exp(-9) = 1.2e-4 [SX15 section 4.1]. */
enum { GAUSSIAN_REACH = 3 }; /* [-] of b */

/* Volumes that differ by less are treated as equal, because the edges are
 * rounded [-]. */
static const double rounding = 1e-9; /* [-] of the largest */

struct kernel {
    const struct cell_of_particle *h; /* borrowed */
    struct weights *weights;
    double b; /* [m] */
};

/* [XS11 3.6] as a function of zeta^2. */
static inline double bell(double zeta2)
{
    const double one = zeta2 < 1.0 ? 1.0 - zeta2 : 0.0;
    return (one * one) * (one * one);
}

double kernel_bell(double zeta)
{
    return bell(zeta * zeta);
}

/* [XS11 3.5b] divides by the sum, and so the weights add up to one [XS11 3.4].
 * Returns 0 if no centre is within reach. */
static int normalise(int n, double sum, double *restrict w)
{
    if (!(sum > 0.0)) return 0;
    const double share = 1.0 / sum;
    for (int e = 0; e < n; e++)
        w[e] *= share;
    return 1;
}

/* The bell of particle i in the cells around its cell, and the sum of it. */
static double bell_weights(const struct kernel *k, int i,
                           const struct neighbourhood *near, double *restrict w)
{
    const double *const restrict dx = near->dx;
    const double *const restrict dy = near->dy;
    const double *const restrict dz = near->dz;
    const double *const o = &k->h->offset[3 * i];
    const double x = o[0], y = o[1], z = o[2];
    const double per_b2 = 1.0 / (k->b * k->b);
    double sum = 0.0;

#pragma omp simd reduction(+ : sum)
    for (int e = 0; e < near->n; e++) {
        const double rx = dx[e] - x, ry = dy[e] - y, rz = dz[e] - z;
        w[e] = bell((rx * rx + ry * ry + rz * rz) * per_b2);
        sum += w[e];
    }
    return sum;
}

/* The same with the Gaussian. */
static double gaussian_weights(const struct kernel *k, int i,
                               const struct neighbourhood *near,
                               double *restrict w)
{
    const double *const o = &k->h->offset[3 * i];
    const double per_b2 = 1.0 / (k->b * k->b);
    double sum = 0.0;

    for (int e = 0; e < near->n; e++) {
        const double rx = near->dx[e] - o[0], ry = near->dy[e] - o[1],
                     rz = near->dz[e] - o[2];
        const double zeta2 = (rx * rx + ry * ry + rz * rz) * per_b2;
        const double far = GAUSSIAN_REACH * GAUSSIAN_REACH;
        w[e] = zeta2 < far ? exp(-zeta2) : 0.0;
        sum += w[e];
    }
    return sum;
}

/* (8.7): the kernel times the volume of the cell [m^3], and the sum of it. */
static double times_volume(const struct kernel *k,
                           const struct neighbourhood *near, double *restrict w)
{
    const double *const V = &k->h->mesh->V[near->cell];
    double sum = 0.0;

    for (int e = 0; e < near->n; e++)
        sum += w[e] *= V[near->index_offset[e]];
    return sum;
}

/* Where all volumes are equal they cancel, as in the printed [XS11 3.5b]. */
static int bell_alike(const void *state, int i,
                      const struct neighbourhood *near, double *w)
{
    return normalise(near->n, bell_weights(state, i, near, w), w);
}

static int bell_by_volume(const void *state, int i,
                          const struct neighbourhood *near, double *w)
{
    bell_weights(state, i, near, w);
    return normalise(near->n, times_volume(state, near, w), w);
}

static int gaussian_alike(const void *state, int i,
                          const struct neighbourhood *near, double *w)
{
    return normalise(near->n, gaussian_weights(state, i, near, w), w);
}

static int gaussian_by_volume(const void *state, int i,
                              const struct neighbourhood *near, double *w)
{
    gaussian_weights(state, i, near, w);
    return normalise(near->n, times_volume(state, near, w), w);
}

static int kernel_has_equal_cells(const struct mesh *m)
{
    double least = m->V[0], most = m->V[0];

    for (int c = 0; c < m->n_cells; c++) {
        least = fmin(least, m->V[c]);
        most = fmax(most, m->V[c]);
    }
    return most - least <= rounding * most;
}

static void *kernel_create_with(const struct cell_of_particle *h,
                                const struct averaging_options *o, double reach,
                                int (*weigh)(const void *, int,
                                             const struct neighbourhood *,
                                             double *))
{
    struct kernel *const k = alloc_zeroed(1, sizeof *k);

    k->h = h;
    k->b = o->bandwidth;
    k->weights = weights_create(h, reach * k->b, STENCIL_TO_CENTRE, o->fields,
                                (struct weights_rule){weigh, k, NULL});
    return k;
}

static void *kernel_create(const struct cell_of_particle *h,
                           const struct averaging_options *o)
{
    return kernel_create_with(h, o, 1.0,
                              kernel_has_equal_cells(h->mesh) ? bell_alike
                                                              : bell_by_volume);
}

static void *gaussian_create(const struct cell_of_particle *h,
                             const struct averaging_options *o)
{
    return kernel_create_with(
        h, o, GAUSSIAN_REACH,
        kernel_has_equal_cells(h->mesh) ? gaussian_alike : gaussian_by_volume);
}

static void kernel_free(void *state)
{
    struct kernel *const k = state;

    weights_free(k->weights);
    free(k);
}

static void kernel_spread(void *state, int m, const double *q, double *field,
                          struct averaging_report *r)
{
    const struct kernel *const k = state;
    r->unsupported = weights_spread(k->weights, m, q, field);
}

static void kernel_gather(void *state, int m, const double *field, double *q,
                          struct averaging_report *r)
{
    const struct kernel *const k = state;

    (void)r;
    weights_gather(k->weights, m, field, q);
}

const struct averaging_method kernel_method = {
    .name = "kernel",
    .what = "a bell-shaped kernel over the neighbouring cells",
    .equations = "XS11 3.2-3.9",
    .function = "bell_weights",
    .keys = {averaging_bandwidth_keys},
    .gaussian = 0.4, /* sqrt(2/13) of a sphere, sqrt(1/6) of a disk */
    .uniform_widths = 1.5,
    .needs_bandwidth = 1,
    .reach_b = 1.0,
    .create = kernel_create,
    .free = kernel_free,
    .spread = kernel_spread,
    .gather = kernel_gather,
};

const struct averaging_method kernel_gaussian_method = {
    .name = "gaussian",
    .what = "a Gaussian kernel over the neighbouring cells",
    .equations = "XS11 3.2-3.5, SX15 6",
    .function = "gaussian_weights",
    .keys = {averaging_bandwidth_keys},
    .gaussian = 1.0,
    .uniform_widths = 0.75,
    .needs_bandwidth = 1,
    .reach_b = GAUSSIAN_REACH,
    .create = gaussian_create,
    .free = kernel_free,
    .spread = kernel_spread,
    .gather = kernel_gather,
};
