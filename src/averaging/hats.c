/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/hats.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/number.h"
#include "base/vector.h"

enum {
    HATS_PARTS = 4,   /* [-] of the particles, each with sums of its own */
    HATS_MANY = 4096, /* [-] particles: fewer are one part */
};

struct hats *hats_create(const struct mesh *mesh, int capacity)
{
    struct hats *const h = owner_create(sizeof *h);

    h->mesh = mesh;
    h->cell = owner_ints(h, 3 * capacity);
    h->next = owner_ints(h, 3 * capacity);
    h->share = owner_doubles(h, 3 * capacity);
    h->place = owner_doubles(h, 3 * capacity);
    if (capacity >= HATS_MANY)
        h->sums = owner_doubles(h, HATS_PARTS * HATS_MOMENTS * mesh->n_cells);
    return h;
}

/* Of particle i along direction k, where it is at x [m]. */
static void hats_find_one(struct hats *h, int i, int k, double x)
{
    const struct box *const b = &h->mesh->box;
    const double *const edge = b->edge[k];
    const int n = b->n[k], at = 3 * i + k;
    int c = number_clamped((x - edge[0]) / (edge[n] - edge[0]) * n, 0, n - 1);

    while (c > 0 && x < edge[c])
        c--;
    while (c < n - 1 && x >= edge[c + 1])
        c++;
    const double width = edge[c + 1] - edge[c];
    const int up = x >= edge[c] + 0.5 * width, next = c + (up ? 1 : -1);
    const int other = b->periodic[k]          ? (next + n) % n
                      : next < 0 || next == n ? c
                                              : next;
    h->cell[at] = c;
    h->next[at] = other;
    h->place[at] = (x - edge[c]) / width;
    h->share[at] = fabs(x - edge[c] - 0.5 * width) /
                   (0.5 * (width + edge[other + 1] - edge[other]));
}

void hats_find(struct hats *h, const struct particles *ps)
{
    h->n = ps->n;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < ps->n; i++) {
        hats_find_one(h, i, 0, ps->x[i]);
        hats_find_one(h, i, 1, ps->y[i]);
        hats_find_one(h, i, 2, ps->z[i]);
    }
}

/* Corner j of particle i, 0 to 7: its cell, and its share [-]; along direction
 * `whole`, 0 to 2, the share is not divided. */
static inline int hats_corner(const struct hats *h, int i, int j, int whole,
                              double *share)
{
    const int *const n = h->mesh->box.n;
    int at[3];

    *share = 1.0;
    for (int k = 0; k < 3; k++) {
        const int other = j >> k & 1;
        at[k] = (other ? h->next : h->cell)[3 * i + k];
        if (k == whole) continue;
        *share *= other ? h->share[3 * i + k] : 1.0 - h->share[3 * i + k];
    }
    return at[0] + n[0] * (at[1] + n[1] * at[2]);
}

/* --- sums over particles on cells ----------------------------------------- */

/* Adds the m numbers q of particles first ... last - 1 to sums on cells. */
typedef void hats_sum(const struct hats *h, int first, int last, int m,
                      const double *q, double *sums);

/* Many particles are divided into a fixed number of parts, and the sums of the
 * parts are added in order: the same bits for any number of threads. */
static void hats_in_parts(const struct hats *h, hats_sum *add, int m, int width,
                          const double *q, double *field)
{
    const int n = width * h->mesh->n_cells;
    const int parts = h->n < HATS_MANY ? 1 : HATS_PARTS;
    double *const sums = parts > 1 ? h->sums : field;

#pragma omp parallel for schedule(static) if (parts > 1)
    for (int p = 0; p < parts; p++) {
        memset(&sums[p * n], 0, (size_t)n * sizeof *sums);
        add(h, h->n / parts * p, p < parts - 1 ? h->n / parts * (p + 1) : h->n,
            m, q, &sums[p * n]);
    }
    if (parts == 1) return;
#pragma omp parallel for schedule(static)
    for (int e = 0; e < n; e++) {
        field[e] = sums[e];
        for (int p = 1; p < parts; p++)
            field[e] += sums[p * n + e];
    }
}

static void hats_add_cells(const struct hats *h, int first, int last, int m,
                           const double *q, double *sums)
{
    double share;

    for (int i = first; i < last; i++)
        for (int j = 0; j < 8; j++) {
            const int c = hats_corner(h, i, j, -1, &share);
            for (int k = 0; k < m; k++)
                sums[m * c + k] += share * q[m * i + k];
        }
}

void hats_spread(const struct hats *h, int m, const double *q, double *field)
{
    hats_in_parts(h, hats_add_cells, m, m, q, field);
    for (int c = 0; c < h->mesh->n_cells; c++)
        for (int k = 0; k < m; k++)
            field[m * c + k] /= h->mesh->V[c];
}

void hats_gather(const struct hats *h, int m, const double *field, double *q)
{
#pragma omp parallel for schedule(static)
    for (int i = 0; i < h->n; i++) {
        double share;
        for (int k = 0; k < m; k++)
            q[m * i + k] = 0.0;
        for (int j = 0; j < 8; j++) {
            const int c = hats_corner(h, i, j, -1, &share);
            for (int k = 0; k < m; k++)
                q[m * i + k] += share * field[m * c + k];
        }
    }
}

/* Of the six halves of cell c the one of particle i along k. */
static inline int hats_half(const struct hats *h, int i, int c, int k)
{
    return 6 * c + 2 * k + (h->place[3 * i + k] >= 0.5);
}

static void hats_add_to_halves(const struct hats *h, int first, int last, int m,
                               const double *q, double *sums)
{
    double share;

    for (int i = first; i < last; i++)
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 8; j++) {
                if (j >> k & 1) continue;
                const int c = hats_corner(h, i, j, k, &share);
                sums[hats_half(h, i, c, k)] += share * q[m * i];
            }
}

void hats_spread_halves(const struct hats *h, const double *q, double *half)
{
    hats_in_parts(h, hats_add_to_halves, 1, 6, q, half);
}

void hats_add_halves(const struct hats *h, const double *half, double *q)
{
#pragma omp parallel for schedule(static)
    for (int i = 0; i < h->n; i++)
        for (int k = 0; k < 3; k++)
            for (int j = 0; j < 8; j++) {
                double share;
                if (j >> k & 1) continue;
                const int c = hats_corner(h, i, j, k, &share);
                q[3 * i + k] += share * half[hats_half(h, i, c, k)];
            }
}

void hats_moments(const struct hats *h, const struct particles *ps, double *q,
                  double *moments)
{
#pragma omp parallel for schedule(static)
    for (int i = 0; i < ps->n; i++) {
        const double v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]};
        const double V = particles_volume(ps, i);
        const double all[HATS_MOMENTS] = {V,
                                          V * v[0],
                                          V * v[1],
                                          V * v[2],
                                          V * vector_dot(v, v),
                                          V / particles_grain(ps, i)};
        memcpy(&q[HATS_MOMENTS * i], all, sizeof all);
    }
    hats_spread(h, HATS_MOMENTS, q, moments);
}

double hats_temperature(const double *moments)
{
    const double eps = moments[0];

    if (eps <= 0.0) return 0.0;
    return fmax(0.0, moments[4] / eps -
                         vector_dot(&moments[1], &moments[1]) / (eps * eps)) /
           3.0;
}
