/* spheres.h -- a few spheres in a box, for the tests of the particles. */
#ifndef SPHERES_H
#define SPHERES_H

#include <check.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/dem.h"

/* A box from -half to half; an elastic material without friction, unless the
 * test changes it. */
static inline struct dem_options spheres_options(const struct contact_law *law,
                                                 double step, double half)
{
    const struct dem_options o = {.law = law,
                                  .material = {.young = 1e7,
                                               .poisson = 0.25,
                                               .stiffness = 1e4,
                                               .restitution = 1.0,
                                               .friction = 0.0},
                                  .step = step,
                                  .lo = {-half, -half, -half},
                                  .hi = {half, half, half}};
    return o;
}

static inline int spheres_add(struct particles *ps, double x, double y,
                              double z, double d)
{
    return particles_add(ps, (const double[3]){x, y, z}, d, 2000.0);
}

static inline void spheres_throw(struct particles *ps, int i, double vx,
                                 double vy, double vz)
{
    ps->vx[i] = vx;
    ps->vy[i] = vy;
    ps->vz[i] = vz;
}

static inline void spheres_spin(struct particles *ps, int i, double wx,
                                double wy, double wz)
{
    ps->wx[i] = wx;
    ps->wy[i] = wy;
    ps->wz[i] = wz;
}

/* Where the particle with this id is now. */
static inline int spheres_place(const struct particles *ps, int id)
{
    for (int i = 0; i < ps->n; i++)
        if (ps->id[i] == id) return i;
    return -1;
}

/* A random number in -1 <= r < 1 from a seeded state. */
static inline double spheres_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 4503599627370496.0 - 1.0;
}

/* The measures of one collision. */
struct collision {
    double time;    /* [s] in contact, to a step */
    double overlap; /* [-] largest, over the mean diameter */
    double force;   /* [N] largest on particle 0 across direction 0 */
};

/* Single steps until all contacts have ended. */
static inline struct collision spheres_collide(struct particles *ps,
                                               const struct dem_options *o)
{
    struct dem *const dem = dem_create(ps, o);
    struct dem_report r = {.contacts = 0};
    struct collision c = {0.0, 0.0, 0.0};
    double v = ps->vx[spheres_place(ps, 0)];

    for (int k = 0; k < 1000000; k++) {
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        const int i = spheres_place(ps, 0);
        c.time += r.contacts > 0 ? o->step : 0.0;
        c.overlap = fmax(c.overlap, r.max_overlap);
        c.force = fmax(c.force, ps->m[i] * fabs(ps->vx[i] - v) / o->step);
        v = ps->vx[i];
        if (c.time > 0.0 && r.contacts == 0) break;
    }
    ck_assert_int_eq(r.contacts, 0);
    dem_free(dem);
    return c;
}

/* A lattice of n^3 spheres, diameters d to d (1 + spread), thrown about at up
 * to v in each direction; pitch apart. */
static inline struct particles *spheres_cloud(int n, double d, double spread,
                                              double pitch, double v,
                                              uint64_t seed)
{
    struct particles *const ps = particles_create(n * n * n);

    for (int k = 0; k < n * n * n; k++) {
        const double at[3] = {k % n, k / n % n, k / n / n};
        const double size =
            d * (1.0 + 0.5 * spread * (1.0 + spheres_random(&seed)));
        const int i = spheres_add(ps, (at[0] - 0.5 * (n - 1)) * pitch,
                                  (at[1] - 0.5 * (n - 1)) * pitch,
                                  (at[2] - 0.5 * (n - 1)) * pitch, size);
        ps->vx[i] = v * spheres_random(&seed);
        ps->vy[i] = v * spheres_random(&seed);
        ps->vz[i] = v * spheres_random(&seed);
    }
    return ps;
}

#endif
