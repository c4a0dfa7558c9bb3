/* SPDX-License-Identifier: GPL-3.0-or-later */
/* kernel.c -- a particle spread over the cells around it.
 * Chapter "Averaging".
 *
 *     w_ic = K(|x_i - x_c| / b) V_c / sum_m K(|x_i - x_m| / b) V_m       (8.7)
 *     field_c = (1 / V_c) sum_i w_ic q_i             [XS11 3.2, 3.5a, 3.7, 3.8]
 *     q_i = sum_c w_ic field_c                                     [XS11 3.9]
 *
 * The weights of a particle sum to one over the cells, so nothing is lost at a
 * wall or anywhere else, whatever K is [XS11 3.4]. A particle with no cell
 * centre within b is assigned to its own cell. [XS11] advises b of 1.5 to 2.5
 * mean cell sizes.
 *
 * As printed, the weights have no V_c: the cells of [XS11] are equal, and it
 * cancels. K V_c is the integral of K over the cell by the midpoint rule, and
 * without V_c small cells beside large ones would seem fuller (8.7).
 *
 *     polynomial  K = (1 - zeta^2)^4 for |zeta| < 1, else 0     [XS11 3.6]
 *     gaussian    K = exp(-zeta^2) for |zeta| < 3, else 0  [SX15 6 and 4.1]
 */
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

/* Writes the kernel of a particle for the cells near its cell, and returns the
 * sum of it. o is its offset from the centre of its cell [m]. */
struct kernel_values {
    double (*of)(double per_b2 /* [1/m^2] */, const double o[3],
                 const struct neighbourhood *near, double *w);
};

struct kernel {
    const struct cell_of_particle *h; /* borrowed */
    struct kernel_values values;
    double b;        /* [m] */
    const double *V; /* [m^3] of the cells; NULL: all are equal and cancel */
};

/* [XS11 3.6] as a function of zeta^2. */
static inline double polynomial(double zeta2)
{
    const double one = zeta2 < 1.0 ? 1.0 - zeta2 : 0.0;
    return (one * one) * (one * one);
}

double kernel_polynomial(double zeta)
{
    return polynomial(zeta * zeta);
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

/* K as a function of zeta^2, which is known where this is inlined: only then
 * does the compiler vectorise the loop. */
static inline __attribute__((always_inline)) double
values_of(double (*K)(double zeta2), double per_b2, const double o[3],
          const struct neighbourhood *near, double *restrict w)
{
    const double *const restrict dx = near->dx;
    const double *const restrict dy = near->dy;
    const double *const restrict dz = near->dz;
    const double x = o[0], y = o[1], z = o[2];
    double sum = 0.0;

#pragma omp simd reduction(+ : sum)
    for (int e = 0; e < near->n; e++) {
        const double rx = dx[e] - x, ry = dy[e] - y, rz = dz[e] - z;
        w[e] = K((rx * rx + ry * ry + rz * rz) * per_b2);
        sum += w[e];
    }
    return sum;
}

static double polynomial_weights(double per_b2, const double o[3],
                                 const struct neighbourhood *near, double *w)
{
    return values_of(polynomial, per_b2, o, near, w);
}

static inline double gaussian(double zeta2)
{
    return zeta2 < GAUSSIAN_REACH * GAUSSIAN_REACH ? exp(-zeta2) : 0.0;
}

static double gaussian_weights(double per_b2, const double o[3],
                               const struct neighbourhood *near, double *w)
{
    return values_of(gaussian, per_b2, o, near, w);
}

/* (8.7): the kernel times the volume of the cell [m^3], and the sum of it. */
static double times_volume(const struct kernel *k,
                           const struct neighbourhood *near, double *restrict w)
{
    const double *const V = &k->V[near->cell];
    double sum = 0.0;

    for (int e = 0; e < near->n; e++)
        sum += w[e] *= V[near->index_offset[e]];
    return sum;
}

/* Where all volumes are equal they cancel, as in the printed [XS11 3.5b]. */
static int kernel_weigh(const void *state, int i,
                        const struct neighbourhood *near, double *w)
{
    const struct kernel *const k = state;
    const double sum =
        k->values.of(1.0 / (k->b * k->b), &k->h->offset[3 * i], near, w);

    return normalise(near->n, k->V != NULL ? times_volume(k, near, w) : sum, w);
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

static void *kernel_create(const struct cell_of_particle *h,
                           const struct averaging_options *o)
{
    const struct kernel_values *const values = o->method->variety;
    struct kernel *const k = alloc_zeroed(1, sizeof *k);

    k->h = h;
    k->b = o->bandwidth;
    k->values = *values;
    k->V = kernel_has_equal_cells(h->mesh) ? NULL : h->mesh->V;
    return weights_create(h, o->method->reach_b * k->b, STENCIL_TO_CENTRE,
                          o->fields,
                          (struct weights_rule){kernel_weigh, k, free});
}

const struct averaging_method kernel_method = {
    .name = "kernel",
    .what = "a bell-shaped kernel over the neighbouring cells",
    .equations = "XS11 3.2-3.9",
    .function = "polynomial_weights",
    .keys = {averaging_bandwidth_keys},
    .gaussian = 0.4, /* sqrt(2/13) of a sphere, sqrt(1/6) of a disk */
    .uniform_widths = 1.5,
    .needs_bandwidth = 1,
    .reach_b = 1.0,
    .variety = &(const struct kernel_values){polynomial_weights},
    .create = kernel_create,
    .free = weights_free,
    .spread = weights_spread,
    .gather = weights_gather,
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
    .variety = &(const struct kernel_values){gaussian_weights},
    .create = kernel_create,
    .free = weights_free,
    .spread = weights_spread,
    .gather = weights_gather,
};
