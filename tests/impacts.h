/* SPDX-License-Identifier: GPL-3.0-or-later */
/* impacts.h -- impacts of one sphere on a rigid plane or another sphere, for
 * the tests of chapter "Particles, verified" and its figures.
 *
 * The plane is made rigid by giving the material, which is the plane's too,
 * twice its Young's modulus: then E* = E/(1 - nu^2) and G* = G/(2 - nu), as if
 * the plane did not yield.
 */
#ifndef IMPACTS_H
#define IMPACTS_H

#include <gsl/gsl_math.h>

#include "dem/contact_hertz.h"
#include "dem/contact_linear.h"
#include "dem/dem.h"

enum impact_partner { RIGID_PLANE, EQUAL_SPHERE, BIG_SPHERE };

/* The sphere moves down on a plane, along x, spinning about z. A partner that
 * is a sphere lies below; an equal one is thrown at the first one, so that
 * each of the two has v_n, v_t in opposite directions and the same spin. */
struct impact {
    enum impact_partner partner;
    double R, density;     /* [m], [kg/m^3] */
    double young, poisson; /* [Pa], [-] */
    double e, mu;          /* [-] */
    double v_n, v_t;       /* [m/s] down and along x */
    double spin;           /* [rad/s] about z */
    double k, k_t;         /* [N/m] law "linear"; 0: law "hertz" */
};

struct rebound {
    double v_n, v_t;       /* [m/s] up and along x */
    double spin;           /* [rad/s] */
    double time;           /* [s] in contact */
    double overlap, force; /* [m], [N] the largest */
};

/* Parts of the largest overlap's time; the errors are below 0.1 %. */
static const double impact_parts = 1000.0;

static inline struct dem_options impact_options(const struct impact *c)
{
    const int plane = c->partner == RIGID_PLANE;
    const double E = plane ? 2.0 * c->young : c->young, nu = c->poisson;
    const double m = 4.0 / 3.0 * M_PI * pow(c->R, 3) * c->density;
    const double R_star = c->partner == EQUAL_SPHERE ? 0.5 * c->R : c->R;
    const double m_star = c->partner == EQUAL_SPHERE ? 0.5 * m : m;
    const double closing = (c->partner == EQUAL_SPHERE ? 2.0 : 1.0) * c->v_n;
    const double t = contact_hertz_time(contact_hertz_modulus(E, nu, E, nu),
                                        R_star, m_star, closing);

    return (struct dem_options){
        .law = c->k > 0.0 ? &contact_linear : &contact_hertz,
        .material = {.young = E,
                     .poisson = nu,
                     .stiffness = c->k,
                     .tangential = c->k > 0.0 ? c->k_t / c->k : 0.0,
                     .restitution = c->e,
                     .friction = c->mu},
        .step = t / impact_parts,
        .lo = {-40 * c->R, 0.0, -40 * c->R},
        .hi = {40 * c->R, 80 * c->R, 40 * c->R}};
}

static inline void impact_add(struct particles *ps, double y, double R,
                              double density, const double v[3])
{
    const int i = particles_add(ps, (double[3]){0.0, y, 0.0}, 2.0 * R, density);

    ps->vx[i] = v[0], ps->vy[i] = v[1], ps->wz[i] = v[2];
}

/* The first sphere at a distance of a few steps. */
static inline struct particles *impact_begin(const struct impact *c,
                                             double step)
{
    struct particles *const ps = particles_create(2);
    const double lift = 1.5 * c->v_n * step;
    const double base = c->partner == RIGID_PLANE    ? 0.0
                        : c->partner == EQUAL_SPHERE ? 40.0 * c->R
                                                     : 20.0 * c->R;

    impact_add(ps, base + c->R + lift, c->R, c->density,
               (double[3]){c->v_t, -c->v_n, c->spin});
    if (c->partner == EQUAL_SPHERE)
        impact_add(ps, base - c->R - lift, c->R, c->density,
                   (double[3]){-c->v_t, c->v_n, c->spin});
    if (c->partner == BIG_SPHERE)
        impact_add(ps, base - 5.0 * c->R, 5.0 * c->R, 1000.0 * c->density,
                   (double[3]){0.0, 0.0, 0.0});
    return ps;
}

/* After every step `seen`, unless NULL, is called with the force and the
 * overlap. */
typedef void impact_seen(void *to, double time, double overlap, double force);

static inline struct rebound impact_watch(const struct impact *c,
                                          impact_seen *seen, void *to)
{
    const struct dem_options o = impact_options(c);
    struct particles *const ps = impact_begin(c, o.step);
    struct dem *const dem = dem_create(ps, &o);
    const double d = c->partner == BIG_SPHERE ? 6.0 * c->R : 2.0 * c->R;
    struct rebound b = {0};
    struct dem_report r = {.contacts = 0};
    int i = 0;

    while (b.time == 0.0 || r.contacts > 0) {
        if (dem_run(dem, 1, &r) != 0) break;
        for (i = 0; ps->id[i] != 0; i++)
            ;
        const double force = hypot(ps->cfx[i], ps->cfy[i]);
        b.time += r.contacts > 0 ? o.step : 0.0;
        b.overlap = fmax(b.overlap, d * r.max_overlap);
        b.force = fmax(b.force, force);
        if (seen) seen(to, b.time, d * r.max_overlap, force);
    }
    b.v_n = ps->vy[i], b.v_t = ps->vx[i], b.spin = ps->wz[i];
    dem_free(dem);
    particles_free(ps);
    return b;
}

static inline struct rebound impact_run(const struct impact *c)
{
    return impact_watch(c, NULL, NULL);
}

#endif
