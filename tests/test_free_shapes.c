/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Boxes, cylinders and closed surfaces that move freely and touch. */
#include "resolved.h"

#include <stdlib.h>
#include <string.h>

#include "base/vector.h"
#include "facts.h"
#include "resolved/shapes/block_contacts.h"
#include "resolved/body_motion.h"
#include "resolved/shapes/shapes.h"

static const double middle[3] = {0.5, 0.5, 0.5}, none[3] = {0.0, 0.0, 0.0},
                    size[3] = {0.4, 0.2, 0.3}; /* of the box */

static struct body_shape box_turned_by(double x, double y, double z)
{
    const struct body_shape box = body_shape_box(size);
    const double rotation[3] = {x, y, z};
    struct body_outline *const o = block_outline_create(&box, rotation);

    contact_points_add(o);
    return body_shape_outline(o);
}

static struct body_shape free_cylinder(double d, double length, double x,
                                       double y, double z)
{
    const double axis[3] = {x, y, z};
    const struct body_shape cylinder = body_shape_cylinder(d, length, axis);
    struct body_outline *const o = block_outline_create(&cylinder, none);

    contact_points_add(o);
    return body_shape_outline(o);
}

/* --- shapes ----------------------------------------------------------------
 */

/* Its triangles are another way to the same numbers, up to rounding. */
FACT(ew18_3_a_turned_box_is_the_box_of_its_triangles)
{
    const struct body_shape box = box_turned_by(0.3, -0.5, 0.7);
    struct body_outline *const o = box.outline;
    const char *trouble;
    double t[12][3][3];

    for (int f = 0; f < 12; f++) /* every second side has them inward */
        for (int v = 0; v < 3; v++)
            memcpy(t[f][v], o->corner[f][f / 2 % 2 ? v : 2 - v],
                   sizeof t[f][v]);
    struct body_outline *const same = closed_surface_create(12, t, &trouble);
    ck_assert_ptr_nonnull(same);
    ck_assert_double_eq_tol(o->volume, 0.4 * 0.2 * 0.3, 1e-16);
    ck_assert_double_eq_tol(o->volume, same->volume, 1e-16);
    for (int e = 0; e < 6; e++)
        ck_assert_double_eq_tol(o->gyration[e], same->gyration[e], 1e-15);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(o->half[k], same->half[k], 1e-15);
    for (int i = 0; i < 500; i++) {
        const double x[3] = {fmod(0.37 * i, 1.0) - 0.5,
                             fmod(0.61 * i, 1.0) - 0.5,
                             fmod(0.73 * i, 1.0) - 0.5};
        ck_assert_double_eq_tol(o->distance(o, x), same->distance(same, x),
                                1e-14);
    }
    ck_assert_double_ge(fabs(o->gyration[1]), 1e-4); /* it is turned */
    body_outline_free(same);
    body_outline_free(o);
}

/* m (R^2/4 + L^2/12) across the axis and m R^2/2 about it. */
FACT(ew18_3_moments_of_a_cylinder_along_any_axis)
{
    const double a[3] = {2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0};
    const struct body_shape c = free_cylinder(0.2, 0.5, 2.0, -1.0, 2.0);
    const double across = 0.01 / 4.0 + 0.25 / 12.0, about = 0.01 / 2.0;
    const double b[3] = {1.0 / sqrt(5.0), 2.0 / sqrt(5.0), 0.0};
    double G[3];

    body_turn_times(c.outline->gyration, a, G);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(G[k], about * a[k], 1e-16);
    body_turn_times(c.outline->gyration, b, G);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(G[k], across * b[k], 1e-16);
    ck_assert_double_eq_tol(c.outline->volume, M_PI * 0.01 * 0.5, 1e-16);
    body_outline_free(c.outline);
}

/* The width is 0.2 m, so points are 0.1 m apart or less; the largest face has
 * then 5 x 4 of them, and its corners are there. */
FACT(ls_4_3_the_points_that_touch_lie_on_the_surface)
{
    const struct body_shape box = box_turned_by(0.0, 0.0, 0.0);
    const struct body_outline *const o = box.outline;
    int corners = 0;

    ck_assert_double_eq_tol(o->width, 0.2, 1e-15);
    ck_assert_int_ge(o->n_balls, 40);
    for (int i = 0; i < o->n_balls; i++) {
        const double *const x = o->ball[i].at;
        double nearest = HUGE_VAL;
        ck_assert_double_eq_tol(o->distance(o, x), 0.0, 1e-15);
        for (int j = 0; j < o->n_balls; j++) {
            double r[3];
            vector_between(x, o->ball[j].at, r);
            if (j != i) nearest = fmin(nearest, vector_length(r));
        }
        ck_assert_double_le(nearest, 0.1 + 1e-12);
        ck_assert_double_ge(nearest, 0.05 - 1e-12);
        corners += fabs(x[0]) > 0.2 - 1e-9 && fabs(x[1]) > 0.1 - 1e-9 &&
                   fabs(x[2]) > 0.15 - 1e-9;
    }
    ck_assert_int_eq(corners, 8);
    ck_assert_int_ge(o->flat, 12);
    ck_assert_int_le(o->flat, 40);
    body_outline_free(box.outline);
}

static void put_corner(double corner[3], const double at[2], double z)
{
    corner[0] = at[0], corner[1] = at[1], corner[2] = z;
}

/* The triangles of a prism; corner 0 of its base sees all others. */
static int extrude(int n, const double (*x)[2], double depth, double (*t)[3][3])
{
    int m = 0;

    for (int k = 1; k + 1 < n; k++, m += 2) {
        const int base[3] = {0, k + 1, k}, top[3] = {0, k, k + 1};
        for (int v = 0; v < 3; v++) {
            put_corner(t[m][v], x[base[v]], 0.0);
            put_corner(t[m + 1][v], x[top[v]], depth);
        }
    }
    for (int k = 0; k < n; k++, m += 2) {
        const double *const a = x[k], *const b = x[(k + 1) % n];
        put_corner(t[m][0], a, 0.0);
        put_corner(t[m][1], b, 0.0);
        put_corner(t[m][2], a, depth);
        put_corner(t[m + 1][0], b, 0.0);
        put_corner(t[m + 1][1], b, depth);
        put_corner(t[m + 1][2], a, depth);
    }
    return m;
}

/* A plate of 0.01 m and an L with legs of 0.025 m, turned in their file by 0.6
 * about z and then about x; their boxes are ten times as wide. The points that
 * touch are half of that apart, or a 48th of the longest side. */
FACT_FOR_EACH(ls_4_3_a_closed_surface_is_as_thin_as_most_of_it, 2)
{
    static const double plate[4][2] = {{0, 0},
                                       {0.5, 0},
                                       {0.5, 0.01},
                                       {0, 0.01}},
                        ell[6][2] = {{0, 0},         {0.5, 0},     {0.5, 0.025},
                                     {0.025, 0.025}, {0.025, 0.5}, {0, 0.5}};
    const double thin = _i == 0 ? 0.01 : 0.025, c = cos(0.6), s = sin(0.6);
    double t[20][3][3];
    const char *trouble;

    const int m = extrude(_i == 0 ? 4 : 6, _i == 0 ? plate : ell, 0.4, t);
    for (int k = 0; k < 3 * m; k++) {
        double *const x = t[k / 3][k % 3];
        const double y = s * x[0] + c * x[1];
        x[0] = c * x[0] - s * x[1];
        x[1] = c * y - s * x[2];
        x[2] = s * y + c * x[2];
    }
    struct body_outline *const o = closed_surface_create(m, t, &trouble);
    ck_assert_ptr_nonnull(o);
    ck_assert_double_eq_tol(o->width, thin, 1e-12);
    ck_assert_double_gt(fmin(o->half[0], fmin(o->half[1], o->half[2])),
                        5.0 * thin);
    contact_points_add(o);
    const double longest = 2.0 * fmax(o->half[0], fmax(o->half[1], o->half[2]));
    for (int i = 0; i < o->n_balls; i++) {
        double r[3], nearest = HUGE_VAL;
        for (int j = 0; j < o->n_balls; j++) {
            vector_between(o->ball[i].at, o->ball[j].at, r);
            if (j != i) nearest = fmin(nearest, vector_length(r));
        }
        ck_assert_double_le(nearest, fmax(0.5 * thin, longest / 48.0) + 1e-12);
    }
    body_outline_free(o);
}

/* --- contacts --------------------------------------------------------------
 */

/* Steps of 1e-3 s in so many parts. */
static struct solid_bodies *dry_box(struct pool *p, int n, int walls, int parts,
                                    double restitution)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {4, 4, 4},
                                   .walls = {walls, walls, walls},
                                   .rho = 1e-9,
                                   .mu = 1e-9,
                                   .dt = 1e-3,
                                   .dem_steps = parts,
                                   .n = n};

    pool_create(p, &o);
    p->bodies->contacts.material = (struct material){
        .stiffness = 50.0, .restitution = restitution, .friction = 0.3};
    return p->bodies;
}

/* Linear and angular momentum about the origin, and the energy of motion. */
static double add_up(const struct solid_bodies *b, double P[3], double L[3])
{
    const struct particles *const ps = b->ps;
    double energy = 0.0;

    memset(P, 0, 3 * sizeof *P);
    memset(L, 0, 3 * sizeof *L);
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]},
                     v[3] = {ps->vx[i], ps->vy[i], ps->vz[i]},
                     w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]}, m = ps->m[i];
        double G[6], spin[3], moment[3];
        body_turn_gyration(b, i, G);
        body_turn_times(G, w, spin);
        vector_cross(x, v, moment);
        energy += 0.5 * m * (vector_dot(v, v) + vector_dot(w, spin));
        for (int k = 0; k < 3; k++) {
            P[k] += m * v[k];
            L[k] += m * (moment[k] + spin[k]);
        }
    }
    return energy;
}

/* A corner on a face, and an edge across an edge. The first one does not move.
 */
static void two_boxes(struct pool *p, int edges)
{
    struct solid_bodies *const b = dry_box(p, 2, 0, 1, 0.8);
    const struct body_shape one = edges ? box_turned_by(0.0, 0.0, 0.785)
                                        : box_turned_by(0.0, 0.0, 0.0),
                            two = edges ? box_turned_by(0.785, 0.0, 0.0)
                                        : box_turned_by(0.5, 0.3, 0.7);

    solid_bodies_add(b, &one, (double[3]){0.5, 0.3, 0.5}, 1.0, BODY_FREE);
    solid_bodies_add(b, &two, (double[3]){0.52, 0.75, 0.47}, 2.0, BODY_FREE);
    b->ps->vy[1] = -1.0;
    b->ps->vx[1] = 0.2;
    ck_assert_int_eq(solid_bodies_begin(b, p->fluid), 0);
}

/* In the moment of the impact: the impulses are equal and opposite and act in
 * one place. Neither comes deeper than a quarter of the width, 0.2 m. */
FACT_FOR_EACH(ls_4_4_contacts_of_boxes_keep_momentum_linear_and_angular, 2)
{
    struct pool p;
    double P[3], L[3], P_0[3], L_0[3], deepest = 0.0;
    int touched = 0;

    two_boxes(&p, _i);
    for (int i = 0; i < 400; i++) {
        add_up(p.bodies, P_0, L_0);
        const double depth = block_contacts_act(p.bodies, 1e-3);
        add_up(p.bodies, P, L);
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(P[k], P_0[k], 1e-16);
            ck_assert_double_eq_tol(L[k], L_0[k], 1e-16);
        }
        touched += depth > 0.0;
        deepest = fmax(deepest, depth);
        ck_assert_int_eq(body_motion_advance(p.bodies, 1e-3), 0);
    }
    ck_assert_int_ge(touched, 5);
    ck_assert_double_le(deepest, 0.25);
    ck_assert_double_ge(p.bodies->ps->vy[1], -0.9); /* it was slowed down */
    pool_free(&p);
}

/* Two bodies from wall to wall, the upper one thrown at the lower one off its
 * middle: discs, or square boxes one of which stands on an edge. Their ends are
 * in the same planes, where points are in neither of them. Neither a weight
 * along the axis nor an impulse that would tilt one moves it. */
static void two_between_walls(struct pool *p, int squares)
{
    const double axis[3] = {0.0, 0.0, 1.0}, edge[3] = {0.0, 0.0, 0.785};
    const struct body_shape shape =
        squares ? body_shape_box((double[3]){0.3, 0.25, 1.0})
                : body_shape_cylinder(0.3, 1.0, axis);

    for (int i = 0; i < 2; i++) {
        struct body_outline *const o =
            block_outline_create(&shape, i == 0 ? edge : none);
        const struct body_shape one = body_shape_outline(o);
        contact_points_add(o);
        contact_points_between(o, 2);
        solid_bodies_add(p->bodies, &one,
                         (double[3]){0.5 + 0.06 * i, 0.3 + 0.4 * i, 0.5}, 1.0,
                         BODY_FREE);
    }
    p->bodies->ps->vy[1] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
}

FACT_FOR_EACH(ls_4_4_bodies_between_two_walls_collide, 2)
{
    struct pool p;
    struct solid_bodies *const b = dry_box(&p, 2, 1, 1, 0.8);
    const struct particles *const ps = b->ps;
    double deepest = 0.0;

    two_between_walls(&p, _i);
    b->options.gravity[2] = -1.0;
    body_motion_add_spin(b, 0, (double[3]){1e-3, 0.0, 0.0});
    for (int i = 0; i < 250; i++) {
        ck_assert_int_eq(body_motion_advance(b, 1e-3), 0);
        deepest = fmax(deepest, b->dem_report.max_overlap);
    }
    /* discs by v sqrt(m/2k) over d = 0.089 at most */
    ck_assert_double_gt(deepest, _i == 0 ? 0.07 : 0.0);
    ck_assert_double_lt(deepest, _i == 0 ? 0.089 : 0.25);
    ck_assert_double_gt(ps->vy[1], ps->vy[0]); /* they part */
    ck_assert_double_lt(ps->vy[0], -0.5);
    ck_assert_double_gt(ps->vx[1], 0.02); /* and to the sides */
    ck_assert_double_gt(fabs(ps->wz[1]), 0.1);
    for (int i = 0; i < 2; i++)
        ck_assert(ps->vz[i] == 0.0 && ps->wx[i] == 0.0 && ps->wy[i] == 0.0);
    pool_free(&p);
}

/* A box thrown onto the floor with a corner first, without losses and without
 * friction: translation turns into spin, the sum stays to the step's error. */
FACT(ls_4_4_an_elastic_box_keeps_its_energy)
{
    struct pool p;
    struct solid_bodies *const b = dry_box(&p, 1, 1, 1, 1.0);
    const struct body_shape box = box_turned_by(0.4, 0.2, 0.9);
    double P[3], L[3];

    b->contacts.material.friction = 0.0;
    solid_bodies_add(b, &box, middle, 1.0, BODY_FREE);
    b->ps->vy[0] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(b, p.fluid), 0);
    const double before = add_up(b, P, L);
    for (int i = 0; i < 400; i++)
        ck_assert_int_eq(body_motion_advance(b, 1e-3), 0);
    ck_assert_double_ge(b->ps->vy[0], -0.5);
    ck_assert_double_ge(fabs(b->ps->wz[0]) + fabs(b->ps->wx[0]), 1.0);
    ck_assert_double_eq_tol(add_up(b, P, L) / before, 1.0, 0.02);
    pool_free(&p);
}

/* Velocity along y of point k of body 0 [m/s]. */
static double speed_of_point(const struct solid_bodies *b, int k)
{
    const struct body_ball ball = body_shape_ball(&b->shape[0], k);
    const double w[3] = {b->ps->wx[0], b->ps->wy[0], b->ps->wz[0]};
    double turn[3];

    vector_cross(w, ball.at, turn);
    return b->ps->vy[0] + turn[1];
}

/* The dashpot is that of the mass which resists at the corner, a third of the
 * box's. Since surfaces do not attract, a restitution of 0.5 becomes exp(-2
 * zeta/w atan(w/zeta)) = 0.551 with w^2 = 1 - zeta^2. The box turns meanwhile
 * by a degree. The whole mass in the dashpot would give 0.35. */
FACT(ls_4_4_the_corner_of_a_box_has_the_restitution_of_its_material)
{
    struct pool p;
    struct solid_bodies *const b = dry_box(&p, 1, 1, 40, 0.5);
    const struct body_shape box = box_turned_by(0.2, 0.0, 0.3);
    int corner = 0, touched = 0;

    b->contacts.material.friction = 0.0;
    b->contacts.material.stiffness = 2e4;
    for (int k = 0; k < box.outline->n_balls; k++)
        if (box.outline->ball[k].at[1] < box.outline->ball[corner].at[1])
            corner = k;
    solid_bodies_add(b, &box, (double[3]){0.5, 0.35, 0.5}, 1.0, BODY_FREE);
    b->ps->vy[0] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(b, p.fluid), 0);
    for (int i = 0; i < 200 && (!touched || b->touching > 0); i++) {
        ck_assert_int_eq(body_motion_advance(b, 1e-3), 0);
        touched |= b->touching > 0;
    }
    ck_assert_int_eq(touched, 1);
    ck_assert_double_eq_tol(speed_of_point(b, corner), 0.551, 0.04);
    pool_free(&p);
}

/* Let go on an edge or on a rim, they come to rest on one of their sides: the
 * centre then is at half of a size, less the overlap that carries the weight.
 */
FACT_FOR_EACH(ls_4_4_a_block_comes_to_rest_on_one_of_its_sides, 3)
{
    static const double half[3][3] = {
        {0.2, 0.1, 0.15}, {0.2, 0.1, 0.15}, {0.1, 0.15, 0.1}};
    const struct body_shape shape[3] = {box_turned_by(0.0, 0.0, 0.4),
                                        box_turned_by(0.7, 0.2, 0.3),
                                        free_cylinder(0.2, 0.3, 0.3, 1.0, 0.1)};
    struct pool p;
    struct solid_bodies *const b = dry_box(&p, 1, 1, 1, 0.5);
    double P[3], L[3], off = HUGE_VAL;

    for (int i = 0; i < 3; i++)
        if (i != _i) body_outline_free(shape[i].outline);
    b->options.gravity[1] = -10.0;
    solid_bodies_add(b, &shape[_i], (double[3]){0.5, 0.35, 0.5}, 1.0,
                     BODY_FREE);
    ck_assert_int_eq(solid_bodies_begin(b, p.fluid), 0);
    for (int i = 0; i < 3000; i++)
        ck_assert_int_eq(body_motion_advance(b, 1e-3), 0);
    const double fallen = b->ps->m[0] * 10.0 * 0.1;
    ck_assert_double_le(add_up(b, P, L), 1e-3 * fallen);
    for (int k = 0; k < 3; k++)
        off = fmin(off, fabs(b->ps->y[0] - half[_i][k]));
    ck_assert_double_le(off, 2e-3);
    pool_free(&p);
}

/* --- in the fluid ----------------------------------------------------------
 */

/* A periodic box with a free body that turns and drifts: fluid and body keep
 * their momentum (24.13) to the solver's tolerance, 1e-10. */
FACT_FOR_EACH(ew18_2_a_free_block_and_the_fluid_keep_their_momentum, 2)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.01,
                                   .virtual_mass = 2.0};
    const struct body_shape shape = _i ? free_cylinder(0.3, 0.4, 1.0, 1.0, 0.0)
                                       : box_turned_by(0, 0.3, 0.5);
    struct pool p;
    double P_0 = 0.0;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &shape, middle, 2.0, BODY_FREE);
    p.bodies->ps->vx[0] = 0.5;
    p.bodies->ps->wz[0] = 2.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 20; i++) {
        double total[3];
        fluid_momentum(p.fluid, total);
        body_motion_add_momentum(p.bodies, total);
        if (i == 0) P_0 = total[0];
        ck_assert_double_eq_tol(total[0] / P_0, 1.0, 1e-8);
        pool_run(&p, 1);
    }
    ck_assert_double_le(p.bodies->ps->vx[0], 0.45);
    ck_assert_double_le(p.bodies->ps->wz[0], 1.9);
    pool_free(&p);
}
