/* linear_case.h -- boxes of links, matrices and numbers for the tests of the
 * linear solvers.
 */
#ifndef LINEAR_CASE_H
#define LINEAR_CASE_H

#include "base/alloc.h"
#include "linear/matrix.h"
#include "linear/solvers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct links {
    int n, n_links, cells[3];
    int *owner, *neighbour;
    double *strength; /* [m] S/d of each link */
    double *link;     /* [m] 3 a link */
    double *V;        /* [m^3] */
    double *at;       /* [m] centre of each cell, 3 a cell */
};

/* A box of nx ny nz cells of size h, x fastest, periodic where wanted. */
static inline struct links links_box(int nx, int ny, int nz, const double h[3],
                                     const int periodic[3])
{
    const int step[3] = {1, nx, nx * ny}, cells[3] = {nx, ny, nz};
    struct links b = {.n = nx * ny * nz, .cells = {nx, ny, nz}};

    b.owner = alloc_ints(3 * b.n);
    b.neighbour = alloc_ints(3 * b.n);
    b.strength = alloc_doubles(3 * b.n);
    b.link = alloc_doubles(9 * b.n);
    b.V = alloc_doubles(b.n);
    b.at = alloc_doubles(3 * b.n);
    for (int c = 0; c < b.n; c++) {
        const int q[3] = {c % nx, c / nx % ny, c / (nx * ny)};

        b.V[c] = h[0] * h[1] * h[2];
        for (int k = 0; k < 3; k++) {
            const int last = q[k] == cells[k] - 1;

            b.at[3 * c + k] = (q[k] + 0.5) * h[k];
            if (last && !periodic[k]) continue;
            b.owner[b.n_links] = c;
            b.neighbour[b.n_links] = last ? c - q[k] * step[k] : c + step[k];
            b.strength[b.n_links] = b.V[c] / (h[k] * h[k]);
            b.link[3 * b.n_links++ + k] = h[k];
        }
    }
    return b;
}

static inline struct links links_cube(int nx, int ny, int nz)
{
    return links_box(nx, ny, nz, (double[3]){1, 1, 1}, (int[3]){0, 0, 0});
}

static inline void links_free(struct links *b)
{
    free(b->owner);
    free(b->neighbour);
    free(b->strength);
    free(b->link);
    free(b->V);
    free(b->at);
}

/* Numbers in [-1, 1] that are the same on every machine and have all their
 * digits: sums of short numbers would be exact in any order. */
static inline double noise(unsigned *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (double)(*seed >> 8) / 8388607.5 - 1.0;
}

static inline double *noise_vector(int n, unsigned seed)
{
    double *const x = alloc_doubles(n);

    for (int i = 0; i < n; i++)
        x[i] = noise(&seed);
    return x;
}

/* Cell i gets the number p[i] of a random order. */
static inline void links_shuffle(struct links *b, unsigned seed)
{
    int *const p = alloc_ints(b->n);
    double *const at = alloc_doubles(3 * b->n);

    for (int i = 0; i < b->n; i++)
        p[i] = i;
    for (int i = b->n - 1; i > 0; i--) {
        const int j = (int)((noise(&seed) + 1.0) * 0.4999 * (i + 1));
        const int t = p[i];

        p[i] = p[j];
        p[j] = t;
    }
    for (int l = 0; l < b->n_links; l++) {
        b->owner[l] = p[b->owner[l]];
        b->neighbour[l] = p[b->neighbour[l]];
    }
    for (int i = 0; i < b->n; i++)
        memcpy(at + 3 * p[i], b->at + 3 * i, 3 * sizeof *at);
    free(b->at);
    free(p);
    b->at = at;
}

/* exp of sines: a range of 7 in two dimensions, of 50 in three. */
static inline double *smooth_coefficients(const struct links *b)
{
    double *const k = alloc_doubles(b->n);

    for (int i = 0; i < b->n; i++) {
        const double x = b->at[3 * i] / b->cells[0];
        const double y = b->at[3 * i + 1] / b->cells[1];
        const double z = b->at[3 * i + 2] / b->cells[2];

        k[i] = exp(sin(6.28 * x) * cos(6.28 * y) +
                   (b->cells[2] > 1 ? cos(6.28 * z) : 0.0));
    }
    return k;
}

/* Blocks of 8 cells a side, each 1 or 1000 at random. */
static inline double *jumping_coefficients(const struct links *b)
{
    double *const k = alloc_doubles(b->n);

    for (int i = 0; i < b->n; i++) {
        unsigned seed = 0;

        for (int d = 0; d < 3; d++) {
            seed =
                (seed + (unsigned)(b->at[3 * i + d] / 8.0) + 1) * 2654435761u;
            seed ^= seed >> 15;
        }
        k[i] = noise(&seed) > 0.0 ? 1000.0 : 1.0;
    }
    return k;
}

/* Widths that grow by a ratio from one end of the box to the other. */
static inline void links_stretch(struct links *b, int k, double ratio)
{
    const int last = b->cells[k] - 1;

    for (int l = 0; l < b->n_links; l++) {
        const double at = b->at[3 * b->owner[l] + k] - 0.5;
        const double here = pow(ratio, at / last);
        const double next = pow(ratio, (at + 1.0) / last);
        double *const d = &b->link[3 * l + k];

        b->strength[l] *= *d > 0.0 ? 2.0 / (here + next) : here;
        if (*d > 0.0) *d = 0.5 * (here + next);
    }
    for (int i = 0; i < b->n; i++)
        b->V[i] *= pow(ratio, (b->at[3 * i + k] - 0.5) / last);
}

/* The matrix of diffusion without flux out. k[c] is the conductivity of a
 * cell, its harmonic mean that of a link; NULL: 1. */
static inline struct csr *diffusion(const struct links *b, const double *k)
{
    struct csr *const A = csr_create(b->n, b->n_links, b->owner, b->neighbour);

    for (int l = 0; l < b->n_links; l++) {
        const int i = b->owner[l], j = b->neighbour[l];
        const double mean = k == NULL ? 1.0 : 2.0 * k[i] * k[j] / (k[i] + k[j]);
        const double g = mean * b->strength[l];

        A->a[A->upper[l]] = A->a[A->lower[l]] = -g;
        A->diag[i] += g;
        A->diag[j] += g;
    }
    return A;
}

/* Adds a wall of value zero in the plane x = 0: half a cell away. */
static inline void add_wall(struct csr *A, const struct links *b,
                            const double *k, const double h[3])
{
    for (int i = 0; i < b->n; i++)
        if (b->at[3 * i] < h[0])
            A->diag[i] += 2.0 * h[1] * h[2] / h[0] * (k == NULL ? 1.0 : k[i]);
}

/* Sets the coefficients of A, which has the same links, from those of `from`.
 */
static inline void set_from(struct preconditioned A, const struct csr *from)
{
    double *const g = alloc_doubles(from->n_links);
    double *const sums = alloc_doubles(from->n);

    for (int l = 0; l < from->n_links; l++)
        g[l] = -from->a[from->upper[l]];
    for (int i = 0; i < from->n; i++) {
        sums[i] = from->diag[i];
        for (int e = from->start[i]; e < from->start[i + 1]; e++)
            sums[i] += from->a[e];
    }
    preconditioned_set(A, g, sums);
    free(g);
    free(sums);
}

/* The same matrix with all its zeros, by rows. */
static inline double *dense_copy(const struct csr *A)
{
    double *const D = alloc_doubles(A->n * A->n);

    for (int i = 0; i < A->n; i++) {
        D[i * A->n + i] += A->diag[i];
        for (int e = A->start[i]; e < A->start[i + 1]; e++)
            D[i * A->n + A->col[e]] += A->a[e];
    }
    return D;
}

static inline double dot_plain(int n, const double *x, const double *y)
{
    double sum = 0.0;

    for (int i = 0; i < n; i++)
        sum += x[i] * y[i];
    return sum;
}

/* |b - A x| / |b|, counted with csr_multiply. */
static inline double true_residual(const struct csr *A, const double *b,
                                   const double *x)
{
    double *const r = alloc_doubles(A->n);

    csr_multiply(A, x, r);
    for (int i = 0; i < A->n; i++)
        r[i] = b[i] - r[i];

    const double share = sqrt(dot_plain(A->n, r, r) / dot_plain(A->n, b, b));

    free(r);
    return share;
}

#endif
