/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/more/kernel_gradient.h"

#include <math.h>
#include <stdlib.h>

#include "averaging/kernel/weights.h"
#include "base/alloc.h"
#include "base/vector.h"

static const double kernel_gradient_reach = 3.0; /* [-] of b */

/* [-] number of particles above which a second thread is faster */
enum { KERNEL_GRADIENT_MANY = 64 };

struct kernel_gradient {
    const struct cell_of_particle *h; /* borrowed */
    struct stencil *near;
    double b;    /* [m] */
    int flat[3]; /* [-] 1: no two cells lie behind each other there */
};

/* The neighbouring cells of a particle and their kernel weights. */
struct kernel_weights {
    int cell, n;
    const int *index_offset;
    double *r; /* [m] from the particle to the centre, 3 an entry */
    double *w; /* [m^3] V_c exp(-r^2 / b^2) */
};

static void collect_weights(const struct kernel_gradient *s, int i,
                            struct kernel_weights *v)
{
    const struct stencil *const near = s->near;
    const int first = near->start[near->shape[v->cell]];
    const double far = kernel_gradient_reach * s->b;

    v->n = near->start[near->shape[v->cell] + 1] - first;
    v->index_offset = &near->index_offset[first];
    for (int e = 0; e < v->n; e++) {
        const double *const o = &s->h->offset[3 * i];
        double *const r = &v->r[3 * e];
        r[0] = near->dx[first + e] - o[0];
        r[1] = near->dy[first + e] - o[1];
        r[2] = near->dz[first + e] - o[2];
        const double r2 = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
        v->w[e] = r2 < far * far ? s->h->mesh->V[v->cell + v->index_offset[e]] *
                                       exp(-r2 / (s->b * s->b))
                                 : 0.0;
    }
}

/* [EW18 B.9], which is the same for all fields of a particle. */
static void find_matrix(const struct kernel_weights *v, double A[6])
{
    for (int j = 0; j < 3; j++)
        for (int k = j; k < 3; k++) {
            double sum = 0.0;
            for (int e = 0; e < v->n; e++)
                sum += v->w[e] * v->r[3 * e + j] * v->r[3 * e + k];
            A[vector_place(j, k)] = sum;
        }
}

/* [EW18 B.3] for field k of m. */
static double kernel_gradient_mean(const struct kernel_weights *v, int m, int k,
                                   const double *field)
{
    double sum = 0.0, weight = 0.0;

    for (int e = 0; e < v->n; e++) {
        sum += v->w[e] * field[m * (v->cell + v->index_offset[e]) + k];
        weight += v->w[e];
    }
    return weight > 0.0 ? sum / weight : field[m * v->cell + k];
}

/* The right-hand side [EW18 B.10] and the solution of [EW18 B.8]; in a row of
 * cells that is the quotient [EW18 B.7]. */
static void kernel_gradient_find_one(const struct kernel_weights *v,
                                     const double A[6], int m, int k,
                                     const double *field, double X[3])
{
    const double here = kernel_gradient_mean(v, m, k, field);
    double B[3] = {0.0, 0.0, 0.0};

    for (int e = 0; e < v->n; e++) {
        const double above =
            field[m * (v->cell + v->index_offset[e]) + k] - here;
        for (int j = 0; j < 3; j++)
            B[j] += v->w[e] * above * v->r[3 * e + j];
    }
    vector_solve(A, B, X);
}

double kernel_gradient_row(double h, double b, double x, double phi_1,
                           double phi_2, double phi_3)
{
    static const int offset[3] = {-1, 0, 1};
    const double field[3] = {phi_1, phi_2, phi_3};
    double r[9] = {0.0}, w[3], A[6], X[3];
    const struct kernel_weights row = {1, 3, offset, r, w};

    for (int e = 0; e < 3; e++) {
        r[3 * e] = (e - 1) * h - x;
        w[e] = exp(-r[3 * e] * r[3 * e] / (b * b));
    }
    find_matrix(&row, A);
    kernel_gradient_find_one(&row, A, 1, 0, field, X);
    return X[0];
}

/* 1 if no link leads along direction k. */
static int kernel_gradient_is_flat(const struct mesh *m, int k)
{
    for (int f = 0; f < m->n_internal; f++) {
        const double *const d = mesh_d(m, f);
        const double d2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        if (d[k] * d[k] > 1e-12 * d2) return 0;
    }
    return 1;
}

struct kernel_gradient *kernel_gradient_create(const struct cell_of_particle *h,
                                               double b)
{
    struct kernel_gradient *const s = alloc_zeroed(1, sizeof *s);

    s->h = h;
    s->b = b;
    for (int k = 0; k < 3; k++)
        s->flat[k] = kernel_gradient_is_flat(h->mesh, k);
    s->near =
        stencil_create(h->mesh, kernel_gradient_reach * b, STENCIL_TO_CENTRE);
    return s;
}

void kernel_gradient_free(struct kernel_gradient *s)
{
    if (s == NULL) return;
    stencil_free(s->near);
    free(s);
}

/* In a direction with one cell all r are equal and do not define a gradient. */
static void drop_flat_directions(const struct kernel_gradient *s, double A[6])
{
    for (int j = 0; j < 3; j++)
        for (int k = 0; k < 3; k++)
            if (s->flat[j]) A[vector_place(j, k)] = 0.0;
}

/* [EW18 B.6] for all particles, from particle to particle; each thread has its
 * own weights. */
void kernel_gradient_find(const struct kernel_gradient *s, int m,
                          const double *field, double *X)
{
    const struct cell_of_particle *const h = s->h;

#pragma omp parallel if (h->n > KERNEL_GRADIENT_MANY)
    {
        struct kernel_weights v = {.r = alloc_doubles(3 * s->near->largest),
                                   .w = alloc_doubles(s->near->largest)};
#pragma omp for schedule(static)
        for (int i = 0; i < h->n; i++) {
            double A[6];
            v.cell = h->cell[i];
            collect_weights(s, i, &v);
            find_matrix(&v, A);
            drop_flat_directions(s, A);
            for (int k = 0; k < m; k++)
                kernel_gradient_find_one(&v, A, m, k, field,
                                         &X[3 * (m * i + k)]);
        }
        free(v.r);
        free(v.w);
    }
}
