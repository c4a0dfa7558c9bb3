/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies of any shape: clumps of spheres, and closed surfaces of triangles. */
#include "resolved.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "facts.h"
#include "resolved/shapes/block_contacts.h"
#include "resolved/body_motion.h"
#include "resolved/shapes/shapes.h"

static const double middle[3] = {0.5, 0.5, 0.5};

/* --- shapes ----------------------------------------------------------------
 */

static const double size[3] = {0.5, 0.3, 0.2}; /* of the box */

/* The box as twelve triangles, its centre at c, the normals outward. */
static void put_box(double (*t)[3][3], const double c[3])
{
    static const int side[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                   {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    static const int half[2][3] = {{0, 1, 2}, {0, 2, 3}};

    for (int f = 0; f < 12; f++)
        for (int v = 0; v < 3; v++)
            for (int k = 0; k < 3; k++) {
                const int corner = side[f / 2][half[f % 2][v]];
                t[f][v][k] = c[k] + (corner >> k & 1 ? 0.5 : -0.5) * size[k];
            }
}

static struct body_outline *box_of_triangles(const double c[3])
{
    double t[12][3][3];
    const char *trouble;

    put_box(t, c);
    struct body_outline *const o = closed_surface_create(12, t, &trouble);
    ck_assert_ptr_nonnull(o);
    return o;
}

/* Point number i of many in and around the unit cube around 0, evenly. */
static void point(int i, double x[3])
{
    static const double step[3] = {0.8191725, 0.6710436, 0.5497005};

    for (int k = 0; k < 3; k++)
        x[k] = fmod(0.5 + i * step[k], 1.0) - 0.5;
}

/* Beside faces, edges and corners, inside and outside. The nearest points of
 * both are the same up to rounding, which is 1e-16 of 1 m. */
FACT(ew18_4_a_box_of_triangles_has_the_distance_of_a_box)
{
    struct body_outline *const o = box_of_triangles(middle);
    const struct body_shape box = body_shape_box(size),
                            same = body_shape_outline(o);

    for (int i = 0; i < 4000; i++) {
        double x[3];
        point(i, x);
        ck_assert_double_eq_tol(body_shape_distance(&same, x),
                                body_shape_distance(&box, x), 1e-14);
    }
    body_outline_free(o);
}

/* Twenty triangles of an icosahedron, each edge halved `times` times, on a
 * sphere of volume V. */
static int put_sphere(double (*t)[3][3], int times, double V)
{
    const double g = 0.5 * (1.0 + sqrt(5.0));
    const double x[12][3] = {{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                             {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                             {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    static const int of[20][3] = {
        {0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
        {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
        {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
        {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    int n = 20;
    double volume = 0.0;

    for (int f = 0; f < 20; f++)
        for (int v = 0; v < 3; v++)
            memcpy(t[f][v], x[of[f][v]], sizeof x[0]);
    for (int l = 0; l < times; l++, n *= 4)
        for (int f = n - 1; f >= 0; f--) {
            double a[3][3], m[3][3];
            memcpy(a, t[f], sizeof a);
            for (int v = 0; v < 3; v++)
                for (int k = 0; k < 3; k++) /* the same from either side */
                    m[v][k] = 0.5 * (a[v][k] + a[(v + 1) % 3][k]);
            for (int v = 0; v < 3; v++) {
                memcpy(t[4 * f + v][0], a[v], sizeof a[v]);
                memcpy(t[4 * f + v][1], m[v], sizeof a[v]);
                memcpy(t[4 * f + v][2], m[(v + 2) % 3], sizeof a[v]);
            }
            memcpy(t[4 * f + 3], m, sizeof m);
        }
    for (int c = 0; c < 3 * n; c++) {
        double *const y = t[c / 3][c % 3], length = vector_length(y);
        for (int k = 0; k < 3; k++)
            y[k] /= length;
    }
    for (int f = 0; f < n; f++) {
        double area[3];
        vector_cross(t[f][1], t[f][2], area);
        volume += vector_dot(t[f][0], area) / 6.0;
    }
    for (int c = 0; c < 9 * n; c++)
        t[c / 9][c / 3 % 3][c % 3] *= cbrt(V / volume);
    return n;
}

/* Solid angle of a triangle from x over 4 pi. */
static double angle_of(const double t[3][3], const double x[3])
{
    double a[3], b[3], c[3], area[3];

    vector_between(t[0], x, a);
    vector_between(t[1], x, b);
    vector_between(t[2], x, c);
    vector_cross(b, c, area);
    const double la = vector_length(a), lb = vector_length(b),
                 lc = vector_length(c);
    return atan2(vector_dot(a, area), la * lb * lc + vector_dot(a, b) * lc +
                                          vector_dot(a, c) * lb +
                                          vector_dot(b, c) * la) /
           (2.0 * M_PI);
}

/* A star of 80 triangles with sharp points and deep notches: most nearest
 * places are edges and corners, where the normal of a triangle alone has the
 * wrong side. The solid angle of the whole surface is 4 pi inside and 0
 * outside. */
FACT(ew18_4_inside_and_outside_are_right_beside_any_corner)
{
    double t[80][3][3];
    const char *trouble;
    int n = put_sphere(t, 1, 1.0), within = 0;

    for (int c = 0; c < 3 * n; c++) {
        double *const x = t[c / 3][c % 3];
        const double some = fabs(37.1 * x[0] + 53.7 * x[1] + 91.3 * x[2]);
        const double R = (0.12 + 0.38 * fmod(some, 1.0)) / vector_length(x);
        for (int k = 0; k < 3; k++)
            x[k] *= R;
    }
    struct body_outline *const o = closed_surface_create(n, t, &trouble);
    ck_assert_ptr_nonnull(o);
    for (int i = 0; i < 4000; i++) {
        double x[3], y[3], around = 0.0;
        point(i, x);
        vector_between(x, o->centre, y);
        for (int f = 0; f < n; f++)
            around += angle_of((const double(*)[3])t[f], x);
        ck_assert_int_eq(o->distance(o, y) < 0.0, around > 0.5);
        within += around > 0.5;
    }
    ck_assert_int_ge(within, 200);
    body_outline_free(o);
}

/* A box that is moved away from the origin, and one whose normals point
 * inward. */
FACT(ew18_3_moments_of_a_box_of_triangles)
{
    const double V = size[0] * size[1] * size[2];

    for (int inward = 0; inward < 2; inward++) {
        double t[12][3][3];
        const char *trouble;
        put_box(t, (double[3]){3.0, -2.0, 1.0});
        for (int f = 0; f < 12 && inward; f++)
            for (int k = 0; k < 3; k++) {
                const double other = t[f][0][k];
                t[f][0][k] = t[f][1][k];
                t[f][1][k] = other;
            }
        struct body_outline *const o = closed_surface_create(12, t, &trouble);
        ck_assert_double_eq_tol(o->volume, V, 1e-13);
        ck_assert_double_eq_tol(o->centre[0], 3.0, 1e-12);
        ck_assert_double_eq_tol(o->gyration[0],
                                (size[1] * size[1] + size[2] * size[2]) / 12.0,
                                1e-11); /* 9 m^2 are taken off */
        ck_assert_double_eq_tol(o->gyration[5],
                                (size[0] * size[0] + size[1] * size[1]) / 12.0,
                                1e-11);
        ck_assert_double_eq_tol(o->gyration[1], 0.0, 1e-11);
        ck_assert_double_eq_tol(o->half[1], 0.5 * size[1], 1e-13);
        ck_assert_double_lt(o->distance(o, (double[3]){0.0, 0.0, 0.0}), 0.0);
        body_outline_free(o);
    }
}

static const char *trouble_of(int n, double (*t)[3][3])
{
    const char *trouble;
    struct body_outline *const o = closed_surface_create(n, t, &trouble);

    body_outline_free(o);
    return o == NULL ? trouble : "none";
}

FACT(ew18_4_a_surface_that_is_not_closed_is_no_body)
{
    double t[13][3][3];

    put_box(t, middle);
    ck_assert_str_eq(trouble_of(12, t), "none");
    ck_assert_ptr_nonnull(strstr(trouble_of(11, t), "one triangle alone"));
    memcpy(t[12], t[0], sizeof t[0]);
    ck_assert_ptr_nonnull(strstr(trouble_of(13, t), "more than two"));
    const double other[3] = {t[5][0][0], t[5][0][1], t[5][0][2]};
    memcpy(t[5][0], t[5][1], sizeof other);
    memcpy(t[5][1], other, sizeof other);
    ck_assert_ptr_nonnull(strstr(trouble_of(12, t), "opposite sides"));
}

/* Two spheres of different sizes, which overlap or not. */
static struct body_outline *dumbbell(double way, struct body_ball ball[2])
{
    ball[0] = (struct body_ball){{0.1, 0.0, 0.0}, 0.2};
    ball[1] = (struct body_ball){{0.1 + way, 0.0, 0.0}, 0.1};
    return clump_create(2, ball);
}

FACT(ew18_4_two_spheres_have_the_distance_of_the_nearer_one)
{
    struct body_ball ball[2];
    struct body_outline *const o = dumbbell(0.25, ball);

    for (int i = 0; i < 1000; i++) {
        double x[3], y[3], s = HUGE_VAL;
        point(i, x);
        vector_between(x, o->centre, y);
        for (int k = 0; k < 2; k++) {
            double r[3];
            vector_between(x, ball[k].at, r);
            s = fmin(s, vector_length(r) - ball[k].R);
        }
        ck_assert_double_eq_tol(o->distance(o, y), s, 1e-15);
    }
    body_outline_free(o);
}

/* A clump of so many spheres that most have to be passed over with many others.
 * The distance is that of the nearest one to the last bit. Of a ball of radius
 * R filled with spheres that reach out to its surface the union has the volume
 * of the ball, but for what is between them there: less than 2 %. */
FACT(ew18_4_a_clump_of_many_spheres_is_found_in_a_tree)
{
    enum { N = 6000 };
    const double R = 0.4, most = 0.1;
    struct body_ball *const ball = alloc_zeroed(N, sizeof *ball);
    int n = 0;

    for (int i = 0; n < N; i++) {
        point(i, ball[n].at);
        ball[n].R = fmin(R - vector_length(ball[n].at), most);
        n += ball[n].R > 0.02;
    }
    struct body_outline *const o = clump_create(N, ball);
    ck_assert_double_eq_tol(o->volume / (4.0 / 3.0 * M_PI * R * R * R), 0.99,
                            0.01);
    for (int i = 0; i < 200; i++) {
        double y[3], least = HUGE_VAL;
        point(7 * i, y);
        for (int k = 0; k < N; k++) {
            double r[3];
            vector_between(y, o->ball[k].at, r);
            least = fmin(least, vector_length(r) - o->ball[k].R);
        }
        ck_assert_double_eq(o->distance(o, y), least);
    }
    body_outline_free(o);
    free(ball);
}

/* Where they overlap, the lens counts once: two caps of the heights h, pi h^2
 * (R - h/3). The columns leave 1e-5 of it. */
FACT(ew18_3_moments_of_two_spheres)
{
    struct body_ball ball[2];
    struct body_outline *o = dumbbell(0.4, ball);
    const double V_1 = 4.0 / 3.0 * M_PI * 0.008, V_2 = V_1 / 8.0, V = V_1 + V_2;

    ck_assert_double_eq_tol(o->volume, V, 1e-15);
    ck_assert_double_eq_tol(o->centre[0], 0.1 + 0.4 * V_2 / V, 1e-15);
    ck_assert_double_eq_tol(o->gyration[0], 0.4 * (V_1 * 0.04 + V_2 * 0.01) / V,
                            1e-15);
    ck_assert_double_eq_tol(o->gyration[3] - o->gyration[0],
                            V_1 * V_2 / (V * V) * 0.16, 1e-15);
    body_outline_free(o);

    o = dumbbell(0.25, ball);
    const double a = (0.0625 + 0.04 - 0.01) / 0.5, h_1 = 0.2 - a,
                 h_2 = 0.1 - (0.25 - a);
    const double lens =
        M_PI * (h_1 * h_1 * (0.2 - h_1 / 3.0) + h_2 * h_2 * (0.1 - h_2 / 3.0));
    ck_assert_double_eq_tol(o->volume / (V - lens), 1.0, 1e-5);
    body_outline_free(o);
}

/* --- in the fluid ----------------------------------------------------------
 */

/* A periodic cube with one fixed body and a mean gradient: the mean flow after
 * a while [m/s]. */
static double flow_around(const struct body_shape *shape)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .rho = 1.0,
                                   .mu = 1.0,
                                   .dt = 1.0 / 144.0,
                                   .gradient = {-1e-6, 0.0, 0.0},
                                   .virtual_mass = 2.0};
    struct pool p;
    double flow[3];

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, shape, middle, 1.0, BODY_FIXED);
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    pool_run(&p, 40);
    fluid_mean_flow(p.fluid, flow);
    pool_free(&p);
    return flow[0];
}

/* Nine cells in the diameter. 1280 triangles of the same volume are within
 * 0.4 % of the radius from the sphere. */
FACT(ew18_4_a_sphere_of_triangles_has_the_drag_of_a_sphere)
{
    static double t[1280][3][3];
    const double d = cbrt(6.0 * 0.216 / M_PI);
    const struct body_shape sphere = body_shape_sphere(d);
    const char *trouble;
    const int n = put_sphere(t, 3, body_shape_volume(&sphere));
    struct body_outline *const o = closed_surface_create(n, t, &trouble);
    ck_assert_ptr_nonnull(o);
    const struct body_shape same = body_shape_outline(o);

    ck_assert_double_eq_tol(o->volume / body_shape_volume(&sphere), 1.0, 1e-12);
    ck_assert_double_eq_tol(flow_around(&same) / flow_around(&sphere), 1.0,
                            2e-3);
}

/* The distances agree to rounding; the solver stops at 1e-10. */
FACT(ew18_4_a_box_of_triangles_has_the_drag_of_a_box)
{
    const struct body_shape box = body_shape_box(size),
                            same = body_shape_outline(box_of_triangles(middle));

    ck_assert_double_eq_tol(flow_around(&same) / flow_around(&box), 1.0, 1e-7);
}

static void fall(struct pool *p, const struct body_shape *shape, int steps)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .walls = {0, 1, 0},
                                   .rho = 1.0,
                                   .mu = 0.01,
                                   .dt = 0.01,
                                   .virtual_mass = 2.0};

    pool_create(p, &o);
    p->bodies->options.gravity[1] = -1.0;
    solid_bodies_add(p->bodies, shape, middle, 2.0, BODY_FREE);
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
    pool_run(p, steps);
}

/* Held, the same bits. A free one spins by rounding, 1e-15 rad/s, and is turned
 * by it: then the distances of its surface round otherwise. */
FACT(ew18_2_a_clump_of_one_sphere_is_the_sphere)
{
    const struct body_ball ball = {.R = 0.2};
    const struct body_shape sphere = body_shape_sphere(0.4),
                            held = body_shape_outline(clump_create(1, &ball)),
                            clump = body_shape_outline(clump_create(1, &ball));
    struct pool a, c;

    ck_assert_double_eq(flow_around(&held), flow_around(&sphere));
    fall(&a, &sphere, 20);
    fall(&c, &clump, 20);
    const struct particles *const x = a.bodies->ps, *const y = c.bodies->ps;
    ck_assert_double_lt(x->vy[0], -0.01);
    ck_assert_double_eq_tol(x->y[0], y->y[0], 1e-13);
    ck_assert_double_eq_tol(x->vy[0], y->vy[0], 1e-12);
    ck_assert_double_eq_tol(a.bodies->force[1], c.bodies->force[1], 1e-12);
    pool_free(&a);
    pool_free(&c);
}

/* --- motion ----------------------------------------------------------------
 */

/* m G w without a torque, also where half of its mass is fluid that has to turn
 * with it: 10 rad/s for 1.6 turns. The error of the energy is 6.1e-7, of
 * second order; explicit Euler's is 4.3e-3. The momentum has rounding alone. */
FACT_FOR_EACH(ew18_3_a_clump_that_tumbles_keeps_momentum_and_energy, 2)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {4, 4, 4},
                                   .rho = _i == 0 ? 1e-9 : 0.5,
                                   .mu = 1e-9,
                                   .dt = 5e-4};
    const struct body_ball ball[3] = {{{0.0, 0.0, 0.0}, 0.1},
                                      {{0.2, 0.0, 0.0}, 0.1},
                                      {{0.0, 0.25, 0.05}, 0.08}};
    const struct body_shape clump = body_shape_outline(clump_create(3, ball));
    struct pool p;
    double before[3], after[3], E = 0.0;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &clump, middle, 1.0, BODY_FREE);
    struct particles *const ps = p.bodies->ps;
    ps->wx[0] = 4.0, ps->wy[0] = 8.0, ps->wz[0] = 4.5;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i <= 2000; i++) {
        const double w[3] = {ps->wx[0], ps->wy[0], ps->wz[0]};
        double G[6];
        body_turn_gyration(p.bodies, 0, G);
        body_turn_times(G, w, i == 0 ? before : after);
        if (i == 0) E = vector_dot(w, before);
        if (i > 0) ck_assert_double_eq_tol(vector_dot(w, after) / E, 1.0, 1e-6);
        ck_assert_int_eq(body_motion_advance(p.bodies, o.dt), 0);
    }
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(after[k], before[k],
                                5e-12 * vector_length(before));
    ck_assert_double_ge(fabs(ps->wy[0] - 8.0), 0.5); /* it does tumble */
    pool_free(&p);
}

/* A clump and a sphere that it hits with one end; a clump and a clump. */
static struct solid_bodies *pair_of_bodies(struct pool *p, int of_clumps)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {4, 4, 4},
                                   .rho = 1e-9,
                                   .mu = 1e-9,
                                   .dt = 1e-3,
                                   .n = 2};
    struct body_ball ball[2];
    const struct body_shape one = body_shape_outline(dumbbell(0.25, ball)),
                            two = of_clumps
                                      ? body_shape_outline(dumbbell(0.4, ball))
                                      : body_shape_sphere(0.2);

    pool_create(p, &o);
    p->bodies->contacts.material = (struct material){
        .stiffness = 100.0, .restitution = 0.8, .friction = 0.3};
    solid_bodies_add(p->bodies, &one, (double[3]){0.3, 0.4, 0.5}, 1.0,
                     BODY_FREE);
    solid_bodies_add(p->bodies, &two, (double[3]){0.35, 0.72, 0.55}, 2.0,
                     BODY_FREE);
    p->bodies->ps->vy[1] = -1.0;
    p->bodies->ps->vx[1] = 0.4;
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
    return p->bodies;
}

/* Linear and angular momentum about the origin. */
static void add_up(const struct solid_bodies *b, double P[3], double L[3])
{
    const struct particles *const ps = b->ps;

    memset(P, 0, 3 * sizeof *P);
    memset(L, 0, 3 * sizeof *L);
    for (int i = 0; i < ps->n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]},
                     w[3] = {ps->wx[i], ps->wy[i], ps->wz[i]},
                     mv[3] = {ps->m[i] * ps->vx[i], ps->m[i] * ps->vy[i],
                              ps->m[i] * ps->vz[i]};
        const double own = 0.1 * ps->d[i] * ps->d[i];
        double G[6] = {own, 0.0, 0.0, own, 0.0, own}, spin[3], moment[3];
        if (b->shape[i].kind == BODY_OUTLINE) body_turn_gyration(b, i, G);
        body_turn_times(G, w, spin);
        vector_cross(x, mv, moment);
        for (int k = 0; k < 3; k++) {
            P[k] += mv[k];
            L[k] += moment[k] + ps->m[i] * spin[k];
        }
    }
}

/* In the moment of the impact: the impulses are equal and opposite and act in
 * one place. */
FACT_FOR_EACH(ls_4_4_contacts_of_clumps_keep_momentum_linear_and_angular, 2)
{
    struct pool p;
    struct solid_bodies *const b = pair_of_bodies(&p, _i);
    double P[3], L[3], P_0[3], L_0[3], depth = 0.0;

    for (int i = 0; i < 400 && depth == 0.0; i++) {
        add_up(b, P_0, L_0);
        depth = block_contacts_act(b, 1e-3);
        add_up(b, P, L);
        if (depth == 0.0) b->ps->x[1] += 4e-4, b->ps->y[1] -= 1e-3;
    }
    ck_assert_double_gt(depth, 0.0);
    ck_assert_double_ge(fabs(b->ps->vy[0]), 1e-3);
    for (int k = 0; k < 3; k++) {
        ck_assert_double_eq_tol(P[k], P_0[k], 1e-15);
        ck_assert_double_eq_tol(L[k], L_0[k], 1e-15);
    }
    pool_free(&p);
}

/* The film does not turn a motion round, and takes nothing of the momentum. */
FACT_FOR_EACH(cox67_a_film_between_clumps_slows_them_down, 2)
{
    struct pool p;
    struct solid_bodies *const b = pair_of_bodies(&p, _i);
    double P[3], L[3], P_0[3], L_0[3];

    b->lubrication = (struct squeeze_film){1e-3, 1e-4, 0.2};
    add_up(b, P_0, L_0);
    const double before = b->ps->vy[1];
    squeeze_film_act(b, 1e-3);
    add_up(b, P, L);
    ck_assert_double_gt(b->ps->vy[1], before);
    ck_assert_double_lt(b->ps->vy[1], 0.0);
    for (int k = 0; k < 3; k++) {
        ck_assert_double_eq_tol(P[k], P_0[k], 1e-15);
        ck_assert_double_eq_tol(L[k], L_0[k], 1e-15);
    }
    pool_free(&p);
}
