/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/cell_of_particle.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "facts.h"
#include "cloud.h"

enum { N = 120 };

FACT_FOR_EACH(every_particle_is_a_member_of_the_cell_that_holds_it_once,
              CLOUD_SHAPES)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[_i]);
    struct particles *const ps = cloud_create(m, N);
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);
    int seen[N] = {0};

    ck_assert_int_eq(cell_of_particle_find(h), 0);
    for (int c = 0; c < m->n_cells; c++)
        for (int a = h->start[c]; a < h->start[c + 1]; a++) {
            const int i = h->particle[a];
            seen[i]++;
            ck_assert_int_eq(h->cell[i], c);
            ck_assert_int_eq(mesh_cell_at(m, ps->x[i], ps->y[i], ps->z[i]), c);
            if (a > h->start[c]) ck_assert_int_gt(i, h->particle[a - 1]);
        }
    for (int i = 0; i < N; i++)
        ck_assert_int_eq(seen[i], 1);
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
}

/* Twice: a second search must not depend on the first. */
FACT(particles_are_found_where_they_went)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[4]);
    struct particles *const ps = cloud_create(m, N);
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);

    ck_assert_int_eq(cell_of_particle_find(h), 0);
    ps->n = 3;
    for (int i = 0; i < 3; i++) {
        ps->x[i] = m->centre[3 * 17];
        ps->y[i] = m->centre[3 * 17 + 1];
        ps->z[i] = m->centre[3 * 17 + 2];
    }
    ck_assert_int_eq(cell_of_particle_find(h), 0);
    ck_assert_int_eq(h->start[17], 0);
    ck_assert_int_eq(h->start[18], 3);
    ck_assert_int_eq(h->start[m->n_cells], 3);
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
}

/* Offsets reach to the walls of the cell and not farther, also where the
 * particle has left a periodic box and counts as one of its images. The slack
 * is rounding of coordinates of order 1. */
FACT_FOR_EACH(offsets_end_at_the_walls_of_the_particles_cell, CLOUD_SHAPES)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[_i]);
    struct particles *const ps = cloud_create(m, N);
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);
    double *const x[3] = {ps->x, ps->y, ps->z};

    for (int i = 0; i < N; i++)
        for (int k = 0; k < 3; k++)
            if (m->box.periodic[k])
                x[k][i] += cloud_shapes[_i].size[k] * (i % 5 - 2);
    ck_assert_int_eq(cell_of_particle_find(h), 0);
    for (int i = 0; i < N; i++) {
        const int c = h->cell[i], *const n = m->box.n;
        const int at[3] = {c % n[0], c / n[0] % n[1], c / n[0] / n[1]};
        for (int k = 0; k < 3; k++) {
            const double *const e = &m->box.edge[k][at[k]];
            ck_assert_double_le(fabs(h->offset[3 * i + k]),
                                0.5 * (e[1] - e[0]) + 1e-14);
        }
    }
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
}

FACT(particles_outside_or_nowhere_are_counted)
{
    struct mesh *const m = mesh_create_box(&cloud_shapes[4]);
    struct particles *const ps = cloud_create(m, N);
    struct cell_of_particle *const h = cell_of_particle_create(m, ps);

    ps->x[5] = -1e-12;
    ps->y[50] = INFINITY;
    ps->z[70] = NAN;
    ck_assert_int_eq(cell_of_particle_find(h), 3);
    ck_assert_int_eq(h->cell[5], -1);
    ck_assert_int_eq(h->cell[50], -1);
    ck_assert_int_eq(h->cell[70], -1);
    owner_free(h);
    particles_free(ps);
    mesh_free(m);
}
