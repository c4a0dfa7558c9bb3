/* SPDX-License-Identifier: GPL-3.0-or-later */
/* cloud.h -- meshes of every special kind, with particles in every special
 * place, for the tests of src/averaging. */
#ifndef CLOUD_H
#define CLOUD_H

#include <check.h>
#include <stdint.h>
#include <stdlib.h>

#include "averaging/averaging.h"
#include "base/alloc.h"
#include "mesh/mesh.h"
#include "dem/particles.h"

/* One cell, one, two and three directions, graded, periodic with one, two and
 * more cells. The widest grading is milder than the 1:5 of test_mesh. */
static const struct box_spec cloud_shapes[] = {
    {{0.3, 0.3, 0.3}, {1, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}},
    {{0.2, 1.2, 0.2}, {1, 9, 1}, {1.0, 3.0, 1.0}, {0, 0, 0}},
    {{0.9, 0.7, 0.2}, {9, 7, 1}, {1.0, 1.0, 1.0}, {1, 0, 1}},
    {{0.5, 0.7, 0.2}, {5, 7, 2}, {1.0, 2.0, 1.0}, {1, 1, 1}},
    {{0.6, 0.7, 0.5}, {6, 7, 5}, {3.0, 0.5, 1.0}, {0, 0, 0}},
    {{0.6, 0.8, 0.7}, {6, 8, 7}, {1.0, 1.0, 1.0}, {1, 1, 1}},
};
enum { CLOUD_SHAPES = sizeof cloud_shapes / sizeof *cloud_shapes };

/* A random number in 0 <= r < 1 from a seeded state. */
static inline double cloud_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static inline void cloud_place(struct particles *ps, double x, double y,
                               double z, double d)
{
    const int i = ps->n++;
    ps->x[i] = x;
    ps->y[i] = y;
    ps->z[i] = z;
    ps->d[i] = d;
    ps->id[i] = 1000 + i;
}

/* The 27 corners, edge and side middles of the box and its centre; 5 on inner
 * faces and 5 in one cell; the rest anywhere. */
static inline struct particles *cloud_create(const struct mesh *m, int n)
{
    struct particles *const ps = particles_create(n);
    const double *const *const e = (const double *const *)m->box.edge;
    const int *const N = m->box.n;
    uint64_t state = 7;

    for (int s = 0; s < 27 && ps->n < n; s++)
        cloud_place(ps, 0.5 * (s % 3) * e[0][N[0]],
                    0.5 * (s / 3 % 3) * e[1][N[1]], 0.5 * (s / 9) * e[2][N[2]],
                    0.02);
    for (int s = 0; s < 5 && ps->n < n; s++)
        cloud_place(ps, e[0][(s + 1) % (N[0] + 1)], e[1][s % (N[1] + 1)],
                    0.3 * e[2][1], 0.01 + 0.001 * s);
    for (int s = 0; s < 5 && ps->n < n; s++)
        cloud_place(ps, 0.1 * s * e[0][1], 0.9 * e[1][1], 0.5 * e[2][1], 0.01);
    while (ps->n < n) {
        const double x = e[0][N[0]] * cloud_random(&state);
        const double y = e[1][N[1]] * cloud_random(&state);
        const double z = e[2][N[2]] * cloud_random(&state);
        cloud_place(ps, x, y, z, 0.01 + 0.01 * cloud_random(&state));
    }
    return ps;
}

/* n numbers in -1 <= r < 1. */
static inline void cloud_numbers(uint64_t seed, int n, double *q)
{
    for (int i = 0; i < n; i++)
        q[i] = 2.0 * cloud_random(&seed) - 1.0;
}

/* Particles of amount 1, averaged. */
static inline void cloud_spread_ones(const struct mesh *m, struct particles *ps,
                                     double b, const char *method,
                                     double *field)
{
    const struct averaging_options o = {.bandwidth = b};
    double *const q = alloc_doubles(ps->n);
    struct averaging *const a =
        averaging_create(averaging_method_named(method), m, ps, &o);

    for (int i = 0; i < ps->n; i++)
        q[i] = 1.0;
    ck_assert_int_eq(averaging_bind(a), 0);
    averaging_spread(a, 1, q, field);
    averaging_free(a);
    free(q);
}

#endif
