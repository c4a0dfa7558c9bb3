/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/block_contacts.h"

#include <math.h>

#include "base/vector.h"
#include "dem/box_domain.h"
#include "dem/contact_linear.h"
#include "resolved/body_motion.h"

/* Mass with what is added to it [kg]; of a body that nothing moves none that
 * counts. */
static double mass_of(const struct solid_bodies *b, int i)
{
    const double added = b->ps->added_mass[i];
    return (b->motion[i] == BODY_SPRING ? b->mass[i] : b->ps->m[i]) + added;
}

/* Velocity of body i at the arm r [m] from its centre. */
static void velocity_at(const struct particles *ps, int i, const double r[3],
                        double v[3])
{
    const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};

    vector_cross(w, r, v);
    v[0] += ps->vx[i], v[1] += ps->vy[i], v[2] += ps->vz[i];
}

static void push(struct solid_bodies *b, int i, const double J[3], double sign)
{
    struct particles *const ps = b->ps;
    const double per_mass = sign / mass_of(b, i);
    double *const v[3] = {&ps->vx[i], &ps->vy[i], &ps->vz[i]};

    for (int k = 0; k < 3; k++)
        if (b->motion[i] == BODY_FREE || b->spring[3 * i + k] > 0.0)
            *v[k] += per_mass * J[k];
}

/* The impulse on sphere i that reaches into body j by `depth`, at the slip v.
 */
static void impulse_of(const struct solid_bodies *b, double m, double depth,
                       const double n[3], const double v[3], double dt,
                       double J[3])
{
    const struct material *const of = &b->contacts.material;
    const double zeta = contact_damping_ratio(of->restitution);
    const double eta = 2.0 * zeta * sqrt(m * of->stiffness); /* [LS 4.4] */
    const double v_n = vector_dot(v, n);
    const double F = fmax(of->stiffness * depth - eta * v_n, 0.0);
    double slip[3];

    vector_along(v, -v_n, n, slip);
    const double speed = vector_length(slip);
    /* friction stops the slip of a solid sphere, 2/7 of m each, at most */
    const double rub =
        speed > 0.0 ? fmin(of->friction * F * dt, 2.0 / 7.0 * m * speed) / speed
                    : 0.0;
    for (int k = 0; k < 3; k++)
        J[k] = dt * F * n[k] - rub * slip[k];
}

/* Overlap over the diameter of sphere i with body j; 0 if they do not touch. */
static double touch(struct solid_bodies *b, const struct box_domain *box, int i,
                    int j, double dt)
{
    struct particles *const ps = b->ps;
    const double R = 0.5 * ps->d[i];
    const double r[3] = {box_domain_nearest(box, 0, ps->x[i] - ps->x[j]),
                         box_domain_nearest(box, 1, ps->y[i] - ps->y[j]),
                         box_domain_nearest(box, 2, ps->z[i] - ps->z[j])};
    const double s = body_shape_distance(&b->shape[j], r);
    double n[3], arm_i[3] = {0}, arm_j[3], v[3], v_j[3], J[3], turn[3];

    if (s >= R) return 0.0;
    body_shape_normal(&b->shape[j], r, n);
    vector_along(arm_i, -s, n, arm_i);
    vector_along(r, -s, n, arm_j);
    velocity_at(ps, i, arm_i, v);
    velocity_at(ps, j, arm_j, v_j);
    for (int k = 0; k < 3; k++)
        v[k] -= v_j[k];
    const double m_i = mass_of(b, i);
    const double m = b->motion[j] == BODY_SPRING
                         ? 1.0 / (1.0 / m_i + 1.0 / mass_of(b, j))
                         : m_i;
    impulse_of(b, m, R - s, n, v, dt, J);
    push(b, i, J, 1.0);
    if (b->motion[j] == BODY_SPRING) push(b, j, J, -1.0);
    vector_cross(arm_i, J, turn);
    body_motion_add_spin(b, i, turn);
    return (R - s) / ps->d[i];
}

double block_contacts_act(struct solid_bodies *b, double dt)
{
    const struct dem_options *const o = &b->contacts;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    double deepest = 0.0;

    for (int i = 0; i < b->ps->n; i++)
        for (int j = 0; j < b->ps->n && b->motion[i] == BODY_FREE; j++)
            if (b->shape[j].kind != BODY_SPHERE)
                deepest = fmax(deepest, touch(b, &box, i, j, dt));
    return deepest;
}
