/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/cell_of_particle.h"

#include <assert.h>
#include <math.h>
#include <omp.h>
#include <stdio.h>

#include "base/alloc.h"

/* [-] numbers below which a loop takes less time than starting a second thread.
 */
enum { MIN_PARALLEL_NUMBERS = 8192 };

struct cell_of_particle *cell_of_particle_create(const struct mesh *mesh,
                                                 const struct particles *ps)
{
    struct cell_of_particle *const h = owner_create(sizeof *h);

    h->mesh = mesh;
    h->ps = ps;
    h->cell = owner_ints(h, ps->capacity);
    h->offset = owner_doubles(h, 3 * ps->capacity);
    h->start = owner_ints(h, mesh->n_cells + 1);
    h->particle = owner_ints(h, ps->capacity);
    return h;
}

/* 1 if the point is in cell c of the box, by the same edges as in mesh_cell_at,
 * which decides for points on the upper end. */
static inline int cell_of_particle_is_in(const struct box *b, int c,
                                         const double x[3])
{
    if (c < 0 || b->n[0] == 0) return 0;
    const int row = c / b->n[0];
    const int at[3] = {c - row * b->n[0], row % b->n[1], row / b->n[1]};
    int in = 1;

    for (int k = 0; k < 3; k++)
        in &= x[k] >= b->edge[k][at[k]] && x[k] < b->edge[k][at[k] + 1];
    return in;
}

/* Cell and offset of particle i. In most cases the cell is that of the particle
 * with this index at the last call. In a periodic direction the nearest image
 * of the cell is used. */
static void cell_of_particle_find_one(struct cell_of_particle *h, int i)
{
    const struct box *const b = &h->mesh->box;
    const double x[3] = {h->ps->x[i], h->ps->y[i], h->ps->z[i]};

    if (h->mesh->face_centre != NULL) {
        h->cell[i] = mesh_cell_and_offset(h->mesh, x, &h->offset[3 * i]);
        return;
    }
    const int c = cell_of_particle_is_in(b, h->cell[i], x)
                      ? h->cell[i]
                      : mesh_cell_at(h->mesh, x[0], x[1], x[2]);

    h->cell[i] = c;
    if (c < 0) return;
    for (int k = 0; k < 3; k++) {
        double *const o = &h->offset[3 * i + k];
        *o = x[k] - h->mesh->centre[3 * c + k];
        if (!b->periodic[k]) continue;
        const double period = b->edge[k][b->n[k]] - b->edge[k][0];
        *o -= period * rint(*o / period);
    }
}

static int count_lost(const struct cell_of_particle *h)
{
    const struct particles *const ps = h->ps;
    int lost = 0;

    for (int i = 0; i < ps->n; i++)
        if (h->cell[i] < 0 && lost++ == 0)
            fprintf(stderr,
                    "winnow: particle %d is outside the mesh, "
                    "at (%g, %g, %g) m\n",
                    ps->id[i], ps->x[i], ps->y[i], ps->z[i]);
    return lost;
}

/* Counting sort: count, add up, place. While particles are placed start[c] is
 * the next free place of c; at the end it has become the start of c + 1. */
static void sort_by_cell(struct cell_of_particle *h)
{
    int *const start = h->start;
    const int n_cells = h->mesh->n_cells;

    for (int c = 0; c <= n_cells; c++)
        start[c] = 0;
    for (int i = 0; i < h->n; i++)
        start[h->cell[i]]++;
    for (int c = 0, sum = 0; c <= n_cells; c++) {
        const int count = start[c];
        start[c] = sum;
        sum += count;
    }
    for (int i = 0; i < h->n; i++)
        h->particle[start[h->cell[i]]++] = i;
    for (int c = n_cells; c > 0; c--)
        start[c] = start[c - 1];
    start[0] = 0;
}

int cell_of_particle_find(struct cell_of_particle *h)
{
    const int n = h->ps->n;
    assert(n <= h->ps->capacity);

#pragma omp parallel for schedule(static) if (n > MIN_PARALLEL_NUMBERS / 8)
    for (int i = 0; i < n; i++)
        cell_of_particle_find_one(h, i);
    const int lost = count_lost(h);
    if (lost > 0) return lost;
    h->n = n;
    sort_by_cell(h);
    return 0;
}

/* Loops over the particles in their order, for one thread: each cell sums in
 * the same order as below, and this loop is faster (half the time for a bed
 * that is not sorted in memory), but two threads would write to the same cell.
 */
static void sum_by_particles(const struct cell_of_particle *h, int m,
                             const double *q, double *field)
{
    const int n = m * h->mesh->n_cells;

    for (int e = 0; e < n; e++)
        field[e] = 0.0;
    for (int i = 0; i < h->n; i++) {
        double *const f = &field[m * h->cell[i]];
        for (int k = 0; k < m; k++)
            f[k] += q[m * i + k];
    }
    for (int e = 0; e < n; e++)
        field[e] /= h->mesh->V[e / m];
}

void cell_of_particle_sum(const struct cell_of_particle *h, int m,
                          const double *q, double *field)
{
    const int n_cells = h->mesh->n_cells;

    if (omp_get_max_threads() == 1) {
        sum_by_particles(h, m, q, field);
        return;
    }
#pragma omp parallel for schedule(static) if (m * h->n > MIN_PARALLEL_NUMBERS)
    for (int c = 0; c < n_cells; c++) {
        double *const f = &field[m * c];
        for (int k = 0; k < m; k++)
            f[k] = 0.0;
        for (int a = h->start[c]; a < h->start[c + 1]; a++)
            for (int k = 0; k < m; k++)
                f[k] += q[m * h->particle[a] + k];
        for (int k = 0; k < m; k++)
            f[k] /= h->mesh->V[c];
    }
}

void cell_of_particle_value(const struct cell_of_particle *h, int m,
                            const double *field, double *q)
{
#pragma omp parallel for schedule(static) if (m * h->n > MIN_PARALLEL_NUMBERS)
    for (int i = 0; i < h->n; i++)
        for (int k = 0; k < m; k++)
            q[m * i + k] = field[m * h->cell[i] + k];
}
