/* SPDX-License-Identifier: GPL-3.0-or-later */
/* grains.h -- a few spheres in a box, for the tests of the particles room. */
#ifndef GRAINS_H
#define GRAINS_H

#include <math.h>
#include <stdint.h>

#include "particles/dem.h"

/* A box that nobody reaches. */
static inline struct dem_options grains_in_space(const char *law, double step)
{
    struct dem_options o = {.law = contact_law_named(law),
                            .material = {.young = 1e7,
                                         .poisson = 0.3,
                                         .stiffness = 1e4,
                                         .restitution = 1.0},
                            .step = step,
                            .lo = {-10.0, -10.0, -10.0},
                            .hi = {10.0, 10.0, 10.0}};
    return o;
}

/* The index of the particle with that id. */
static inline int grains_at(const struct particles *ps, int id)
{
    int i = 0;
    while (ps->id[i] != id)
        i++;
    return i;
}

static inline void grains_throw(struct particles *ps, int i, double vx,
                                double vy, double vz)
{
    ps->vx[i] = vx;
    ps->vy[i] = vy;
    ps->vz[i] = vz;
}

/* A number in 0 <= r < 1 from a state that one seeds. */
static inline double grains_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

/* n spheres of d (1 - spread) ... d (1 + spread), on a lattice that fills the
 * box but for some room, with velocities up to v in each direction. */
static inline struct particles *grains_cloud(const struct dem_options *o, int n,
                                             double d, double spread, double v,
                                             uint64_t seed)
{
    struct particles *const ps = particles_create(n);
    const double a = 1.05 * d * (1.0 + spread);
    int m[3];

    for (int k = 0; k < 3; k++)
        m[k] = (int)((o->hi[k] - o->lo[k]) / a);
    for (int i = 0; i < n; i++) {
        const int site[3] = {i % m[0], i / m[0] % m[1], i / m[0] / m[1]};
        const double own =
            d * (1.0 + spread * (2.0 * grains_random(&seed) - 1.0));
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] = o->lo[k] + (site[k] + 0.5) * a;
        const int p = particles_add(ps, x, own, 1000.0);
        ps->vx[p] = v * (2.0 * grains_random(&seed) - 1.0);
        ps->vy[p] = v * (2.0 * grains_random(&seed) - 1.0);
        ps->vz[p] = v * (2.0 * grains_random(&seed) - 1.0);
        ps->wx[p] = v / d * (2.0 * grains_random(&seed) - 1.0);
        ps->wy[p] = v / d * (2.0 * grains_random(&seed) - 1.0);
        ps->wz[p] = v / d * (2.0 * grains_random(&seed) - 1.0);
    }
    return ps;
}

#endif
