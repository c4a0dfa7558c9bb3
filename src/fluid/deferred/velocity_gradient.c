/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/schemes.h"

#include <stddef.h>
#include <string.h>

#include "base/alloc.h"
#include "fluid/deferred.h"
#include "fluid/fluid.h"

/* Component k of u at face f: linear between two cells, given on the boundary
 * [m/s]. */
static double velocity_gradient_face_value(const struct mesh *m,
                                           const double *u, const double *u_b,
                                           int f, int k)
{
    if (f >= m->n_internal) return u_b[3 * (f - m->n_internal) + k];
    return m->w[f] * u[3 * m->owner[f] + k] +
           (1.0 - m->w[f]) * u[3 * m->neighbour[f] + k];
}

/* Moves the values of boundary faces from where they hold to the middles, with
 * the slope found so far. As this way lies in the face, that is exact for a
 * cell with one such face, or several that are parallel. */
static void move_to_middles(const struct mesh *m, const double *reach,
                            double *slope)
{
    for (int f = m->n_internal; f < m->n_faces; f++) {
        const double *const S = mesh_S(m, f), *const d = mesh_d(m, f);
        const double *const to = &reach[3 * (f - m->n_internal)];
        double *const g = &slope[9 * m->owner[f]];
        for (int k = 0; k < 3; k++) {
            double rise = 0.0;
            for (int j = 0; j < 3; j++)
                rise += g[3 * k + j] * (d[j] - to[j]);
            for (int j = 0; j < 3 && rise != 0.0; j++)
                g[3 * k + j] += rise * S[j] / m->V[m->owner[f]];
        }
    }
}

static void gauss(const struct mesh *m, const double *reach, const double *u,
                  const double *u_b, double *slope)
{
    for (int c = 0; c < m->n_cells; c++) {
        double *const g = &slope[9 * c];
        memset(g, 0, 9 * sizeof *g);
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            const double out = (m->owner[f] == c ? 1.0 : -1.0) / m->V[c];
            for (int k = 0; k < 3; k++) {
                const double value =
                    out * velocity_gradient_face_value(m, u, u_b, f, k);
                for (int j = 0; j < 3; j++)
                    g[3 * k + j] += value * mesh_S(m, f)[j];
            }
        }
    }
    if (reach != NULL) move_to_middles(m, reach, slope);
}

/* The inverse of a symmetric 3 x 3 matrix (xx xy xz yy yz zz). Directions in
 * which the cell has no neighbour have a slope of zero: their diagonal, which
 * is 0, counts as 1. */
static void velocity_gradient_invert(double m[6])
{
    const double trace = m[0] + m[3] + m[5];

    for (int i = 0; i < 6; i += i == 0 ? 3 : 2)
        if (m[i] <= 1e-12 * trace) m[i] = 1.0;
    const double xx = m[3] * m[5] - m[4] * m[4], xy = m[2] * m[4] - m[1] * m[5];
    const double xz = m[1] * m[4] - m[2] * m[3], yy = m[0] * m[5] - m[2] * m[2];
    const double yz = m[1] * m[2] - m[0] * m[4], zz = m[0] * m[3] - m[1] * m[1];
    const double det = m[0] * xx + m[1] * xy + m[2] * xz;
    const double inverse[6] = {xx, xy, xz, yy, yz, zz};

    for (int i = 0; i < 6; i++)
        m[i] = inverse[i] / det;
}

/* Adds the terms of face f of cell c: weight d d to the matrix, and weight d
 * (u_other - u_c) to the right-hand sides. The weight is 1 / |d|^2; among
 * tetrahedra, of which no two neighbours are opposite each other, the square of
 * that, since the error of a difference grows with |d|^2. */
static void velocity_gradient_add_face(const struct mesh *m,
                                       const double *reach, const double *u,
                                       const double *u_b, int c, int f,
                                       double matrix[6], double right[9])
{
    const double sign = m->owner[f] == c ? 1.0 : -1.0;
    const double *const l = reach != NULL && f >= m->n_internal
                                ? &reach[3 * (f - m->n_internal)]
                                : mesh_d(m, f);
    const double d[3] = {sign * l[0], sign * l[1], sign * l[2]};
    const double square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const double weight = 1.0 / (m->skewed == 2 ? square * square : square);
    const double *const beyond = f >= m->n_internal
                                     ? &u_b[3 * (f - m->n_internal)]
                                 : m->owner[f] == c ? &u[3 * m->neighbour[f]]
                                                    : &u[3 * m->owner[f]];

    for (int i = 0, n = 0; i < 3; i++)
        for (int j = i; j < 3; j++, n++)
            matrix[n] += weight * d[i] * d[j];
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            right[3 * k + j] += weight * d[j] * (beyond[k] - u[3 * c + k]);
}

static void least_squares(const struct mesh *m, const double *reach,
                          const double *u, const double *u_b, double *slope)
{
    static const int at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

    for (int c = 0; c < m->n_cells; c++) {
        double matrix[6] = {0.0}, right[9] = {0.0};
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++)
            velocity_gradient_add_face(m, reach, u, u_b, c, m->cell_face[a],
                                       matrix, right);
        velocity_gradient_invert(matrix);
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++) {
                double sum = 0.0;
                for (int j = 0; j < 3; j++)
                    sum += matrix[at[i][j]] * right[3 * k + j];
                slope[9 * c + 3 * k + i] = sum;
            }
    }
}

static void by_mesh(const struct mesh *m, const double *reach, const double *u,
                    const double *u_b, double *slope)
{
    (m->skewed == 2 ? least_squares : gauss)(m, reach, u, u_b, slope);
}

const struct key velocity_gradient_keys[] = {
    {"fluid.gradient", KEY_NAME, "", "", "by-mesh",
     "slope of the velocity, where a scheme asks for it", "", "",
     KEY_AT(fluid_options, velocity_gradient),
     .models = velocity_gradient_schemes},
    KEY_END};

const struct velocity_gradient_scheme velocity_gradient_by_mesh = {
    .name = "by-mesh",
    .what = "least-squares where there are tetrahedra; else gauss",
    .equations = "",
    .function = "by_mesh",
    .fill = by_mesh,
};

const struct velocity_gradient_scheme velocity_gradient_gauss = {
    .name = "gauss",
    .what = "by the theorem of Gauss; conserves",
    .equations = "",
    .function = "gauss",
    .fill = gauss,
};

const struct velocity_gradient_scheme velocity_gradient_least_squares = {
    .name = "least-squares",
    .what = "exact for a linear field on any mesh",
    .equations = "",
    .function = "least_squares",
    .fill = least_squares,
};

double *boundary_reach(const struct mesh *m, const struct boundary *b)
{
    if (!m->skewed) return NULL;
    double *const reach = alloc_doubles(3 * (m->n_faces - m->n_internal));

    for (int i = 0; i < m->n_patches; i++) {
        const struct patch *const p = &m->patches[i];
        const int foot = b[i].kind == BOUNDARY_SLIP ||
                         b[i].kind == BOUNDARY_OUTLET || b[i].walls != NULL;
        for (int f = p->first; f < p->first + p->n; f++) {
            double off[3];
            const int moved = mesh_misses_middle(m, f, off) && foot;
            for (int k = 0; k < 3; k++)
                reach[3 * (f - m->n_internal) + k] =
                    mesh_d(m, f)[k] - (moved ? off[k] : 0.0);
        }
    }
    return reach;
}

void boundary_reach_gradient(const struct fluid *fl, const double *u,
                             const double *u_b, double *slope)
{
    const struct velocity_gradient_scheme *const s =
        fl->options.velocity_gradient != NULL ? fl->options.velocity_gradient
                                              : velocity_gradient_schemes[0];
    const double *const reach =
        fl->deferred != NULL ? fl->deferred->reach : NULL;

    s->fill(fl->mesh, reach, u, u_b, slope);
}

const struct velocity_gradient_scheme *const velocity_gradient_schemes[] = {
    &velocity_gradient_by_mesh, &velocity_gradient_gauss,
    &velocity_gradient_least_squares, NULL};

MODEL_NAMED(velocity_gradient_scheme)
