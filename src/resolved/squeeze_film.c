/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/body_motion.h"

#include <gsl/gsl_math.h>
#include <math.h>

#include "base/vector.h"
#include "dem/box_domain.h"
#include "resolved/shapes/block_contacts.h"

const double squeeze_film_cells = 0.75;

double squeeze_film_coefficient(double mu, double R_star, double z,
                                double z_min, double reach)
{
    if (z <= 0.0 || z >= reach) return 0.0;
    return 6.0 * M_PI * mu * R_star * R_star *
           (1.0 / fmax(z, z_min) - 1.0 / reach);
}

/* The coefficient changes with z: in each part of the time z changes by a fifth
 * at most, and the damping with the coefficient at half of the way is solved
 * exactly. */
double squeeze_film_velocity(const struct squeeze_film *l, double R_star,
                             double m, double z, double g, double dt)
{
    static const double share = 0.2;
    double left = dt;

    while (left > 0.0 && z > 0.0 && z < l->reach && g != 0.0) {
        const double step = fmin(left, share * fmax(z, l->z_min) / fabs(g));
        const double k = squeeze_film_coefficient(
            l->mu, R_star, z + 0.5 * g * step, l->z_min, l->reach);
        const double decay = k * step / m;
        const double kept = exp(-decay);
        z += g * step * (decay > 0.0 ? (1.0 - kept) / decay : 1.0);
        g *= kept;
        left -= step;
    }
    return g;
}

/* Mass with what is added to it [kg]. */
static double squeeze_film_mass_of(const struct particles *ps, int i)
{
    return ps->m[i] + ps->added_mass[i];
}

static void squeeze_film_push(struct particles *ps, int i, double speed,
                              const double n[3])
{
    ps->vx[i] += speed * n[0];
    ps->vy[i] += speed * n[1];
    ps->vz[i] += speed * n[2];
}

static void act_between(struct solid_bodies *b, const struct box_domain *box,
                        int i, int j, double dt)
{
    struct particles *const ps = b->ps;
    const double R_i = 0.5 * ps->d[i], R_j = 0.5 * ps->d[j];
    const double v[3] = {ps->vx[i] - ps->vx[j], ps->vy[i] - ps->vy[j],
                         ps->vz[i] - ps->vz[j]};
    double n[3] = {box_domain_nearest(box, 0, ps->x[i] - ps->x[j]),
                   box_domain_nearest(box, 1, ps->y[i] - ps->y[j]),
                   box_domain_nearest(box, 2, ps->z[i] - ps->z[j])};
    const double r = vector_length(n), z = r - R_i - R_j;

    if (z <= 0.0 || z >= b->lubrication.reach) return;
    vector_unit(n, n);
    const double m_i = squeeze_film_mass_of(ps, i),
                 m_j = squeeze_film_mass_of(ps, j);
    const double m = 1.0 / (1.0 / m_i + 1.0 / m_j), g = vector_dot(v, n);
    const double J =
        m * (squeeze_film_velocity(&b->lubrication, R_i * R_j / (R_i + R_j), m,
                                   z, g, dt) -
             g);
    squeeze_film_push(ps, i, J / m_i, n);
    squeeze_film_push(ps, j, -J / m_j, n);
}

static void act_at_walls(struct solid_bodies *b, const struct box_domain *box,
                         int i, double dt)
{
    struct particles *const ps = b->ps;
    const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
    double *const v[3] = {&ps->vx[i], &ps->vy[i], &ps->vz[i]};
    const double R = 0.5 * ps->d[i];

    for (int w = 0; w < 6; w++) {
        const int k = w / 2;
        const double sign = w % 2 ? -1.0 : 1.0;
        if (box->periodic[k]) continue;
        *v[k] = sign * squeeze_film_velocity(
                           &b->lubrication, R, squeeze_film_mass_of(ps, i),
                           box_domain_gap(box, w, x) - R, sign * *v[k], dt);
    }
}

/* One on a spring is among the balls. */
static int is_sphere(const struct solid_bodies *b, int i)
{
    return b->shape[i].kind == BODY_SPHERE && !solid_bodies_hung(b, i);
}

void squeeze_film_act(struct solid_bodies *b, double dt)
{
    const struct dem_options *const o = &b->contacts;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);

    for (int i = 0; i < b->ps->n; i++) {
        for (int j = i + 1; j < b->ps->n && is_sphere(b, i); j++)
            if (is_sphere(b, j) &&
                (b->motion[i] == BODY_FREE || b->motion[j] == BODY_FREE))
                act_between(b, &box, i, j, dt);
        if (is_sphere(b, i) && b->motion[i] == BODY_FREE)
            act_at_walls(b, &box, i, dt);
    }
    if (b->blocks > 0) block_contacts_film(b, dt);
}
