/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/interpolation.h"

#include "averaging/cell_of_particle.h"
#include "base/model.h"
#include "base/vector.h"

static void nearest(struct averaging *a, int m, const double *field,
                    const double *boundary, double *q)
{
    (void)boundary;
    cell_of_particle_value(averaging_cells(a), m,
                           averaging_extended(a, m, field), q);
}

/* Value on face f of number k of the m. */
static double interpolation_face_value(const struct mesh *mesh, int f, int k,
                                       int m, const double *field,
                                       const double *boundary)
{
    if (f < mesh->n_internal) {
        const double w = mesh->w[f];
        return w * field[m * mesh->owner[f] + k] +
               (1.0 - w) * field[m * mesh->neighbour[f] + k];
    }
    return boundary[m * (f - mesh->n_internal) + k];
}

/* For a cell at the boundary without boundary values: the least-squares
 * gradient of the differences to its neighbours, weighted by the inverse square
 * of the distance. It is exact for linear fields, and zero in directions
 * without a neighbour. */
static void fitted_gradient(const struct mesh *mesh, int c, int k, int m,
                            const double *field, double g[3])
{
    double A[6] = {0.0}, b[3] = {0.0};

    for (int a = mesh->cell_start[c]; a < mesh->cell_start[c + 1]; a++) {
        const int f = mesh->cell_face[a];
        if (f >= mesh->n_internal) break; /* ascending: only boundary follows */
        const int owner = mesh->owner[f] == c;
        const int other = owner ? mesh->neighbour[f] : mesh->owner[f];
        const double *const d = mesh_d(mesh, f);
        const double w = 1.0 / (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        const double difference =
            (owner ? w : -w) * (field[m * other + k] - field[m * c + k]);
        const double dd[6] = {d[0] * d[0], d[0] * d[1], d[0] * d[2],
                              d[1] * d[1], d[1] * d[2], d[2] * d[2]};
        for (int j = 0; j < 6; j++)
            A[j] += w * dd[j];
        for (int j = 0; j < 3; j++)
            b[j] += difference * d[j];
    }
    vector_solve(A, b, g);
}

/* Gauss: (1 / V_c) sum over the faces of S (phi_f - phi_c). The S of a closed
 * cell sum to zero; phi_c is subtracted so that the gradient of a constant is
 * exactly zero. */
static void gradient(const struct mesh *mesh, int c, int k, int m,
                     const double *field, const double *boundary, double g[3])
{
    const int last = mesh->cell_face[mesh->cell_start[c + 1] - 1];

    g[0] = g[1] = g[2] = 0.0;
    if (boundary == NULL && last >= mesh->n_internal) {
        fitted_gradient(mesh, c, k, m, field, g);
        return;
    }
    for (int a = mesh->cell_start[c]; a < mesh->cell_start[c + 1]; a++) {
        const int f = mesh->cell_face[a];
        const double out = mesh->owner[f] == c ? 1.0 : -1.0;
        const double difference =
            interpolation_face_value(mesh, f, k, m, field, boundary) -
            field[m * c + k];
        for (int j = 0; j < 3; j++)
            g[j] += out * difference * mesh_S(mesh, f)[j];
    }
    for (int j = 0; j < 3; j++)
        g[j] /= mesh->V[c];
}

static void linear(struct averaging *a, int m, const double *values,
                   const double *boundary, double *q)
{
    const struct cell_of_particle *const h = averaging_cells(a);
    const double *const field = averaging_extended(a, m, values);

#pragma omp parallel for schedule(static) if (h->n > 512)
    for (int c = 0; c < h->mesh->n_cells; c++) {
        if (h->start[c] == h->start[c + 1]) continue;
        for (int k = 0; k < m; k++) {
            double g[3];
            gradient(h->mesh, c, k, m, field, boundary, g);
            for (int e = h->start[c]; e < h->start[c + 1]; e++) {
                const int i = h->particle[e];
                const double *const o = &h->offset[3 * i];
                q[m * i + k] =
                    field[m * c + k] + g[0] * o[0] + g[1] * o[1] + g[2] * o[2];
            }
        }
    }
}

static void interpolation_same_values(struct averaging *a, int m,
                                      const double *field,
                                      const double *boundary, double *q)
{
    (void)boundary;
    averaging_gather(a, m, field, q);
}

const struct interpolation interpolation_nearest = {
    .name = "nearest",
    .what = "the value of the particle's cell",
    .equations = "XS11 3.1",
    .function = "nearest",
    .apply = nearest,
};

const struct interpolation interpolation_linear = {
    .name = "linear",
    .what = "value and gradient (Gauss) of the particle's cell",
    .equations = "Gauss",
    .function = "linear",
    .apply = linear,
};

const struct interpolation interpolation_same = {
    .name = "same",
    .what = "with the weights of the averaging",
    .equations = "XS11 3.9",
    .function = "interpolation_same_values",
    .apply = interpolation_same_values,
};

const struct interpolation *const interpolations[] = {
    &interpolation_nearest, &interpolation_linear, &interpolation_same, NULL};

MODEL_NAMED(interpolation)
