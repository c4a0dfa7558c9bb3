/* SPDX-License-Identifier: GPL-3.0-or-later */
/* block_contacts.c -- contacts of bodies that are not all spheres, and where
 * they come near to one another. */
#include "resolved/shapes/block_contacts.h"

#include "base/vector.h"
#include "dem/box_domain.h"
#include "resolved/body_motion.h"

#include <math.h>
#include <string.h>

/* --- body gaps ------------------------------------------------------------ */

/* What a gap does in a time dt [s]; a number of which the largest counts. */
typedef double body_gap_act(struct solid_bodies *b, const struct body_gap *g,
                            double dt);

static int can_move(const struct solid_bodies *b, int i)
{
    return b->motion[i] == BODY_FREE || b->motion[i] == BODY_SPRING;
}

/* 1 if it consists of balls that are no particles of b->dem. */
static int is_clump(const struct solid_bodies *b, int i)
{
    return b->shape[i].kind == BODY_OUTLINE ? b->shape[i].outline->width == 0.0
                                            : solid_bodies_hung(b, i);
}

/* 1 if points of its surface touch others. */
static int has_points(const struct solid_bodies *b, int i)
{
    return b->shape[i].kind == BODY_OUTLINE && b->shape[i].outline->flat > 0;
}

/* 1 if it is a round one between walls, with one ball in place of points. */
static int is_disc(const struct solid_bodies *b, int i)
{
    return has_points(b, i) && b->shape[i].outline->n_balls == 1;
}

/* Mass with what is added to it [kg]. */
static double body_gaps_mass_of(const struct solid_bodies *b, int i)
{
    return (b->motion[i] == BODY_SPRING ? b->mass[i] : b->ps->m[i]) +
           b->ps->added_mass[i];
}

/* What resists an impulse along n at the arm: 1/(1/M + (arm x n) . I^-1 (arm x
 * n)). Through the centre of a sphere that is its mass. */
static double mass_at(const struct solid_bodies *b, int i, const double arm[3],
                      const double n[3])
{
    const double M = body_gaps_mass_of(b, i);
    double G[6], turn[3], spin[3];

    if (b->shape[i].kind != BODY_OUTLINE || b->motion[i] != BODY_FREE) return M;
    vector_cross(arm, n, turn);
    body_turn_gyration(b, i, G);
    vector_solve(G, turn, spin);
    const double of_spin = M / body_motion_turning_mass(b, i);
    return M / (1.0 + of_spin * vector_dot(turn, spin));
}

/* Velocity of body i at the arm r [m] from its centre. */
static void body_gaps_velocity_at(const struct particles *ps, int i,
                                  const double r[3], double v[3])
{
    const double w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]};

    vector_cross(w, r, v);
    v[0] += ps->vx[i], v[1] += ps->vy[i], v[2] += ps->vz[i];
}

static void body_gaps_add_impulse(struct solid_bodies *b, int i,
                                  const double arm[3], const double J[3],
                                  double sign)
{
    struct particles *const ps = b->ps;
    const double per_mass = sign / body_gaps_mass_of(b, i);
    double *const v[3] = {&ps->vx[i], &ps->vy[i], &ps->vz[i]};
    double turn[3];

    for (int k = 0; k < 3; k++)
        if (body_motion_moves_along(b, i, k)) *v[k] += per_mass * J[k];
    vector_cross(arm, J, turn);
    for (int k = 0; k < 3; k++)
        turn[k] *= sign;
    body_motion_add_spin(b, i, turn);
}

/* The impulse J [N s] on i, its negative on j. */
static void body_gaps_push(struct solid_bodies *b, const struct body_gap *g,
                           const double J[3])
{
    body_gaps_add_impulse(b, g->i, g->arm_i, J, 1.0);
    if (g->j >= 0 && can_move(b, g->j))
        body_gaps_add_impulse(b, g->j, g->arm_j, J, -1.0);
}

/* With i, j, z, R, n known: the arms, the velocity and the mass. `from` is the
 * centre of the ball from that of i, `to` from that of j [m]. */
static void body_gaps_complete(const struct solid_bodies *b,
                               const double from[3], const double to[3],
                               struct body_gap *g)
{
    const double s = g->z + g->R;
    double v_j[3] = {0.0, 0.0, 0.0};

    vector_along(from, -s, g->n, g->arm_i);
    vector_along(to, -s, g->n, g->arm_j);
    body_gaps_velocity_at(b->ps, g->i, g->arm_i, g->v);
    if (g->j >= 0) body_gaps_velocity_at(b->ps, g->j, g->arm_j, v_j);
    vector_between(g->v, v_j, g->v);
    const double m_i = mass_at(b, g->i, g->arm_i, g->n);
    g->m = m_i;
    if (g->j < 0 || !can_move(b, g->j)) return;
    const double m_j = mass_at(b, g->j, g->arm_j, g->n);
    g->m = can_move(b, g->i) ? 1.0 / (1.0 / m_i + 1.0 / m_j) : m_j;
}

/* Radius of the ball of a body that is nearest to r [m]; a surface counts as
 * flat. */
static double radius_near(const struct body_shape *shape, const double r[3])
{
    double nearest = HUGE_VAL, R = HUGE_VAL;

    if (shape->kind == BODY_OUTLINE && shape->outline->width > 0.0) return R;
    for (int k = 0; k < body_shape_balls(shape); k++) {
        const struct body_ball ball = body_shape_ball(shape, k);
        double away[3];
        vector_between(r, ball.at, away);
        if (vector_length(away) - ball.R >= nearest) continue;
        nearest = vector_length(away) - ball.R;
        R = ball.R;
    }
    return R;
}

static double beside_body(struct solid_bodies *b, const struct box_domain *box,
                          const struct body_ball *ball, struct body_gap *g,
                          double reach, double dt, body_gap_act *act)
{
    const struct particles *const ps = b->ps;
    const int i = g->i, j = g->j;
    const double r[3] = {
        box_domain_nearest(box, 0, ps->x[i] + ball->at[0] - ps->x[j]),
        box_domain_nearest(box, 1, ps->y[i] + ball->at[1] - ps->y[j]),
        box_domain_nearest(box, 2, ps->z[i] + ball->at[2] - ps->z[j])};

    g->R = ball->R;
    g->z = body_shape_distance(&b->shape[j], r) - ball->R;
    if (g->z >= reach) return 0.0;
    body_shape_normal(&b->shape[j], r, g->n);
    g->R_j = radius_near(&b->shape[j], r);
    body_gaps_complete(b, ball->at, r, g);
    return act(b, g, dt);
}

static double beside_walls(struct solid_bodies *b, const struct box_domain *box,
                           const struct body_ball *ball, struct body_gap *g,
                           double reach, double dt, body_gap_act *act)
{
    const struct particles *const ps = b->ps;
    const double x[3] = {ps->x[g->i] + ball->at[0], ps->y[g->i] + ball->at[1],
                         ps->z[g->i] + ball->at[2]};
    double most = 0.0;

    g->R = ball->R;
    g->R_j = HUGE_VAL;
    for (int w = 0; w < 6; w++) {
        if (box->periodic[w / 2] || !body_motion_moves_along(b, g->i, w / 2))
            continue;
        g->z = box_domain_gap(box, w, x) - ball->R;
        if (g->z >= reach) continue;
        memset(g->n, 0, sizeof g->n);
        g->n[w / 2] = w % 2 ? -1.0 : 1.0;
        body_gaps_complete(b, ball->at, ball->at, g);
        most = fmax(most, act(b, g, dt));
    }
    return most;
}

/* A block on a spring, which does not turn: where it reaches to. */
static double block_beside_walls(struct solid_bodies *b,
                                 const struct box_domain *box,
                                 struct body_gap *g, double reach, double dt,
                                 body_gap_act *act)
{
    double extent[3], most = 0.0;

    body_shape_extent(&b->shape[g->i], extent);
    for (int k = 0; k < 3; k++) {
        struct box_domain within = *box;
        for (int e = 0; e < 3; e++) {
            within.periodic[e] |= e != k;
            within.lo[e] += extent[e];
            within.hi[e] -= extent[e];
        }
        const struct body_ball centre = {.R = 0.0};
        most = fmax(most, beside_walls(b, &within, &centre, g, reach, dt, act));
    }
    return most;
}

/* The balls of i act upon j, if one of the two can move: a clump on all that is
 * no clump, and on a clump after it; a sphere on what does not consist of
 * balls; points on this too, and a disc on a disc after it. */
static int acts_on(const struct solid_bodies *b, int i, int j)
{
    if (i == j || !(can_move(b, i) || can_move(b, j))) return 0;
    if (is_clump(b, i)) return !is_clump(b, j) || i < j;
    if (is_disc(b, i) && is_disc(b, j)) return i < j;
    return !is_clump(b, j) && b->shape[j].kind != BODY_SPHERE;
}

/* 1 if nothing of i is nearer than `reach` [m] to j, as their extents show. */
static int far_apart(const struct solid_bodies *b, const struct box_domain *box,
                     int i, int j, double reach)
{
    const struct particles *const ps = b->ps;
    const double r[3] = {box_domain_nearest(box, 0, ps->x[i] - ps->x[j]),
                         box_domain_nearest(box, 1, ps->y[i] - ps->y[j]),
                         box_domain_nearest(box, 2, ps->z[i] - ps->z[j])};
    double of_i[3], of_j[3];

    body_shape_extent(&b->shape[i], of_i);
    body_shape_extent(&b->shape[j], of_j);
    for (int k = 0; k < 3; k++)
        if (fabs(r[k]) > of_i[k] + of_j[k] + reach) return 1;
    return 0;
}

/* Those that i acts on and may be near to, in b->near; returns their number. */
static int look_around(struct solid_bodies *b, const struct box_domain *box,
                       int i, double reach)
{
    int n = 0;

    for (int j = 0; j < b->ps->n; j++)
        if (acts_on(b, i, j) && !far_apart(b, box, i, j, reach))
            b->near[n++] = j;
    return n;
}

/* All gaps narrower than `reach` [m] between bodies of which one can move. */
static double body_gaps_each(struct solid_bodies *b, double reach, double dt,
                             body_gap_act *act)
{
    const struct dem_options *const o = &b->contacts;
    const struct box_domain box = box_domain_of(o->lo, o->hi, o->periodic);
    double most = 0.0;

    for (int i = 0; i < b->ps->n; i++) {
        const int n = look_around(b, &box, i, reach);
        const int walls =
            can_move(b, i) && (is_clump(b, i) || has_points(b, i));
        for (int k = 0; k < body_shape_balls(&b->shape[i]); k++) {
            const struct body_ball ball = body_shape_ball(&b->shape[i], k);
            struct body_gap g = {.i = i};
            for (int e = 0; e < n; e++) {
                g.j = b->near[e];
                most =
                    fmax(most, beside_body(b, &box, &ball, &g, reach, dt, act));
            }
            g.j = -1;
            if (walls)
                most = fmax(most,
                            beside_walls(b, &box, &ball, &g, reach, dt, act));
        }
        struct body_gap g = {.i = i, .j = -1};
        if (b->motion[i] == BODY_SPRING && body_shape_balls(&b->shape[i]) == 0)
            most = fmax(most, block_beside_walls(b, &box, &g, reach, dt, act));
    }
    return most;
}

/* How deep the deepest ball of i is in j [m]; 0 where it may be: a tenth of its
 * radius, or a twentieth of the width of a surface. */
static double too_deep(const struct solid_bodies *b,
                       const struct box_domain *box, int i, int j)
{
    const struct particles *const ps = b->ps;
    const double share =
        has_points(b, i) ? 0.05 * b->shape[i].outline->width : 0.0;
    double most = 0.0;

    for (int k = 0; k < body_shape_balls(&b->shape[i]); k++) {
        const struct body_ball ball = body_shape_ball(&b->shape[i], k);
        const double r[3] = {
            box_domain_nearest(box, 0, ps->x[i] + ball.at[0] - ps->x[j]),
            box_domain_nearest(box, 1, ps->y[i] + ball.at[1] - ps->y[j]),
            box_domain_nearest(box, 2, ps->z[i] + ball.at[2] - ps->z[j])};
        const double depth = ball.R - body_shape_distance(&b->shape[j], r);
        if (depth > fmax(0.1 * ball.R, share)) most = fmax(most, depth);
    }
    return most;
}

double body_gaps_width(const struct solid_bodies *b, const struct body_gap *g)
{
    return g->R > 0.0 ? 2.0 * g->R : body_shape_width(&b->shape[g->i]);
}

double body_gaps_deepest(const struct solid_bodies *b, int pair[2])
{
    const struct box_domain box =
        box_domain_of(b->contacts.lo, b->contacts.hi, b->contacts.periodic);
    double most = 0.0;

    for (int i = 0; i < b->ps->n; i++)
        for (int j = 0; j < b->ps->n; j++) {
            if (i == j || !(can_move(b, i) || can_move(b, j)) ||
                far_apart(b, &box, i, j, 0.0))
                continue;
            const double depth = too_deep(b, &box, i, j);
            if (depth <= most) continue;
            most = depth;
            pair[0] = i, pair[1] = j;
        }
    return most;
}

/* --- block contacts ------------------------------------------------------- */

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

void block_contacts_film(struct solid_bodies *b, double dt)
{
    body_gaps_each(b, b->lubrication.reach, dt, act_in_gap);
}
