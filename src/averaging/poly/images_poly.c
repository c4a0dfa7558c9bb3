/* SPDX-License-Identifier: GPL-3.0-or-later */
/* images_poly.c -- a Gaussian with mirror images on cells of any shape.
 *
 * Chapter "Further averaging methods".
 *
 *     w_ic = sum over c and its images of
 *         V_c N(x_i - x_c; b^2 / 2 + M_c) over the sum of that      (21.6)
 *
 * N is the normal density of that covariance and M_c that of the cell itself,
 * the mean of r r^T over it (facets.h). The images themselves are
 * described in facets.h.
 *
 * Near flat walls the field of a uniform bed is then uniform. Near other walls
 * the heights of the cells are scaled until it is: each cell has one height,
 * and the weights of each particle still add up to one.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "averaging/averaging.h"
#include "averaging/kernel/weights.h"
#include "averaging/poly/facets.h"
#include "base/alloc.h"
#include "base/vector.h"

static const double images_reach = 3.0; /* [-] of b, as in images.c */

/* The iteration stops when the largest correction is below this; the next one
 * would be several times smaller. */
static const double even = 5e-3; /* [-] */
enum { ROUNDS = 8 };

struct images_poly {
    const struct cell_of_particle *h; /* borrowed */
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
static void spread_even(const struct images_poly *s,
                        const struct weights *weights, double *got, double *w)
{
    const struct mesh *const m = s->h->mesh;

    for (int c = 0; c < m->n_cells; c++)
        got[c] = 0.0;
    for (int c = 0; c < m->n_cells; c++) {
        const struct neighbourhood near = weights_around(weights, c);
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
static void make_even(struct images_poly *s, const struct weights *weights)
{
    const struct mesh *const m = s->h->mesh;
    struct gaussian_moments *const N = s->normals;
    double *const got = alloc_doubles(m->n_cells);
    double *const w = alloc_doubles(weights_stencil(weights)->largest);
    double worst = INFINITY;

    for (int round = 0; round < ROUNDS && worst > even; round++) {
        worst = 0.0;
        spread_even(s, weights, got, w);
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

static void images_poly_free(void *state)
{
    struct images_poly *const s = state;

    owner_free(s->normals);
    free(s);
}

static void *images_poly_create(const struct cell_of_particle *h,
                                const struct averaging_options *o)
{
    struct images_poly *const s = alloc_zeroed(1, sizeof *s);
    const double reach = images_reach * o->bandwidth;
    struct facets *const f = facets_create(h->mesh);
    struct wall_images *const m = wall_images_create(f, reach);
    struct weights *const weights = weights_create(
        h, reach, STENCIL_TO_CENTRE, o->fields,
        (struct weights_rule){images_weights, s, images_poly_free});

    s->h = h;
    s->normals = gaussian_moments_create(f, m, o->bandwidth);
    make_even(s, weights);
    wall_images_free(m);
    owner_free(f);
    return weights;
}

const struct averaging_method images_poly_method = {
    .name = "images",
    .what = "a Gaussian kernel with mirror images at walls",
    .equations = "EW18 17-21",
    .function = "images_weights",
    .needs_bandwidth = 1,
    .reach_b = 3.0,
    .create = images_poly_create,
    .free = weights_free,
    .spread = weights_spread,
    .gather = weights_gather,
};

/* --- the moments of cells
 */

static const double far = 9.0; /* [-] exp(-9) is 1.2e-4 */

/* Adds s a a^T. */
static void add_outer(double M[6], double s, const double a[3])
{
    M[0] += s * a[0] * a[0];
    M[1] += s * a[0] * a[1];
    M[2] += s * a[0] * a[2];
    M[3] += s * a[1] * a[1];
    M[4] += s * a[1] * a[2];
    M[5] += s * a[2] * a[2];
}

/* The tetrahedron from the centre of the cell to a triangle: 6 times its volume
 * with that sign, and its part of the integral of r r^T [m^5]. */
static double add_tetrahedron(double M[6], double sign, const double a[3],
                              const double b[3], const double c[3])
{
    double n[3], sum[3];

    vector_cross(a, b, n);
    const double V6 = sign * vector_dot(n, c);
    for (int k = 0; k < 3; k++)
        sum[k] = a[k] + b[k] + c[k];
    add_outer(M, V6 / 120.0, a);
    add_outer(M, V6 / 120.0, b);
    add_outer(M, V6 / 120.0, c);
    add_outer(M, V6 / 120.0, sum);
    return V6;
}

/* The mean of r r^T over cell c [m^2]. */
static void find_moment(const struct facets *f, int c, double M[6])
{
    const struct mesh_shape *const s = f->mesh->shape;
    double V6 = 0.0;

    for (int k = 0; k < 6; k++)
        M[k] = 0.0;
    for (int i = s->cell_start[c]; i < s->cell_start[c + 1]; i++)
        for (int j = f->of[s->polygon[i]]; j < f->of[s->polygon[i] + 1]; j++) {
            const int *const at = &f->corner[f->start[j]];
            double x[3][3];
            vector_between(&f->point[3 * at[0]], &f->mesh->centre[3 * c], x[0]);
            for (int e = 1; e + 1 < f->start[j + 1] - f->start[j]; e++) {
                for (int k = 0; k < 2; k++)
                    vector_between(&f->point[3 * at[e + k]],
                                   &f->mesh->centre[3 * c], x[1 + k]);
                V6 += add_tetrahedron(M, s->turned[i], x[0], x[1], x[2]);
            }
        }
    for (int k = 0; k < 6; k++)
        M[k] *= 6.0 / V6;
}

/* A = half the inverse of C, and the determinant of C is returned. */
static double half_inverse(const double C[6], double A[6])
{
    const double c00 = C[3] * C[5] - C[4] * C[4];
    const double c01 = C[2] * C[4] - C[1] * C[5];
    const double c02 = C[1] * C[4] - C[2] * C[3];
    const double det = C[0] * c00 + C[1] * c01 + C[2] * c02;

    A[0] = 0.5 * c00 / det;
    A[1] = 0.5 * c01 / det;
    A[2] = 0.5 * c02 / det;
    A[3] = 0.5 * (C[0] * C[5] - C[2] * C[2]) / det;
    A[4] = 0.5 * (C[1] * C[2] - C[0] * C[4]) / det;
    A[5] = 0.5 * (C[0] * C[3] - C[1] * C[1]) / det;
    return det;
}

/* T M T^T. */
static void turned(const double T[9], const double M[6], double out[6])
{
    const double full[9] = {M[0], M[1], M[2], M[1], M[3],
                            M[4], M[2], M[4], M[5]};
    static const int row[6] = {0, 0, 0, 1, 1, 2}, col[6] = {0, 1, 2, 1, 2, 2};

    for (int k = 0; k < 6; k++) {
        out[k] = 0.0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                out[k] +=
                    T[3 * row[k] + i] * full[3 * i + j] * T[3 * col[k] + j];
    }
}

/* M = L L^T, column after column; a direction without width has none. */
static void find_spread(const double M[6], double L[9])
{
    memset(L, 0, 9 * sizeof *L);
    L[0] = sqrt(fmax(0.0, M[0]));
    if (L[0] > 0.0) L[1] = M[1] / L[0];
    if (L[0] > 0.0) L[2] = M[2] / L[0];
    L[4] = sqrt(fmax(0.0, M[3] - L[1] * L[1]));
    if (L[4] > 0.0) L[5] = (M[4] - L[1] * L[2]) / L[4];
    L[8] = sqrt(fmax(0.0, M[5] - L[2] * L[2] - L[5] * L[5]));
}

/* The normal of cell c, for b^2 / 2 of the Gaussian [m^2]. */
static void find_normal(const struct facets *f, int c, double variance,
                        struct gaussian_moment *n, double L[9])
{
    double C[6];

    find_moment(f, c, C);
    find_spread(C, L);
    C[0] += variance;
    C[3] += variance;
    C[5] += variance;
    const double det = half_inverse(C, n->A) / gsl_pow_3(variance);
    n->height = f->mesh->V[c] / sqrt(det);
    n->offset[0] = n->offset[1] = n->offset[2] = 0.0;
}

struct gaussian_moments *gaussian_moments_create(const struct facets *f,
                                                 const struct wall_images *m,
                                                 double b)
{
    const int n_cells = f->mesh->n_cells;
    struct gaussian_moments *const s = owner_create(sizeof *s);
    int n = 0;

    s->start = owner_ints(s, n_cells + 1);
    s->spread = owner_doubles(s, 9 * n_cells);
    s->moment = owner_zeroed(s, (size_t)n_cells + (size_t)m->start[n_cells],
                             sizeof *s->moment);
    for (int c = 0; c < n_cells; c++) {
        const struct gaussian_moment *const own = &s->moment[n];
        find_normal(f, c, 0.5 * b * b, &s->moment[n++], &s->spread[9 * c]);
        for (int i = m->start[c]; i < m->start[c + 1]; i++, n++) {
            struct gaussian_moment *const image = &s->moment[n];
            turned(m->images[i].rotation, own->A, image->A);
            image->height = own->height * m->images[i].weight;
            memcpy(image->offset, m->images[i].offset, sizeof image->offset);
        }
        s->start[c + 1] = n;
    }
    return s;
}

double gaussian_moments_value(const struct gaussian_moment *n,
                              const double r[3])
{
    const double x = r[0] - n->offset[0], y = r[1] - n->offset[1],
                 z = r[2] - n->offset[2];
    const double *const A = n->A;
    const double zeta2 = x * (A[0] * x + 2.0 * (A[1] * y + A[2] * z)) +
                         y * (A[3] * y + 2.0 * A[4] * z) + A[5] * z * z;
    return zeta2 < far ? n->height * exp(-zeta2) : 0.0;
}
