/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "resolved/blocks/block_contacts.h"

#include <math.h>

#include "base/vector.h"
#include "dem/contact_linear.h"
#include "resolved/blocks/body_gaps.h"
#include "resolved/squeeze_film.h"

/* The impulse on a ball that reaches into the other body by `depth`, at the
 * slip v. */
static void impulse_of(const struct material *of, double m, double depth,
                       const double n[3], const double v[3], double dt,
                       double J[3])
{
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

/* Overlap over the diameter of the ball, or over the width of a surface. */
static double block_contacts_touch(struct solid_bodies *b,
                                   const struct body_gap *g, double dt)
{
    double J[3];

    b->touching++;
    impulse_of(&b->contacts.material, g->m, -g->z, g->n, g->v, dt, J);
    body_gaps_push(b, g, J);
    return -g->z / body_gaps_width(b, g);
}

double block_contacts_act(struct solid_bodies *b, double dt)
{
    b->touching = 0;
    return body_gaps_each(b, 0.0, dt, block_contacts_touch);
}

/* A ball beside a body that is no sphere, or a ball of a clump. Points and
 * discs have no film: what flows out beside a surface is the mesh's. */
static double act_in_gap(struct solid_bodies *b, const struct body_gap *g,
                         double dt)
{
    if (g->R == 0.0 || (b->shape[g->i].kind == BODY_OUTLINE &&
                        b->shape[g->i].outline->width > 0.0))
        return 0.0;
    const double speed = vector_dot(g->v, g->n),
                 R_star = 1.0 / (1.0 / g->R + 1.0 / g->R_j);
    const double gained =
        squeeze_film_velocity(&b->lubrication, R_star, g->m, g->z, speed, dt) -
        speed;
    double J[3];

    for (int k = 0; k < 3; k++)
        J[k] = g->m * gained * g->n[k];
    body_gaps_push(b, g, J);
    return 0.0;
}

static void act_by_films(struct solid_bodies *b, double dt)
{
    body_gaps_each(b, b->lubrication.reach, dt, act_in_gap);
}

const struct body_contacts block_contacts = {
    .act = block_contacts_act, .film = act_by_films, .touch = body_gaps_touch};
