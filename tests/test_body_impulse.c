/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What contacts give a body moves it at once, and is neither delayed nor
 * multiplied by the virtual mass that keeps the reaction of the fluid stable.
 */
#include "resolved.h"

#include "base/vector.h"
#include "facts.h"
#include "resolved/body_motion.h"
#include "resolved/shapes/shapes.h"

static const double middle[3] = {0.5, 0.5, 0.5};

/* A body of 8 cells in a periodic box of a thin fluid, after a few steps at
 * rest. */
static void pool_at_rest(struct pool *p, const struct body_shape *shape,
                         double rho_r)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {16, 16, 16},
                                   .rho = 1.0,
                                   .mu = 1e-6,
                                   .dt = 0.01,
                                   .virtual_mass = 2.0,
                                   .tolerance = 1e-8,
                                   .n = 1};

    pool_create(p, &o);
    solid_bodies_add(p->bodies, shape, middle, rho_r, BODY_FREE);
    ck_assert_int_eq(solid_bodies_begin(p->bodies, p->fluid), 0);
    pool_run(p, 3);
}

/* (24.15): the velocity just after a push is what stays of it when all the
 * fluid has answered, but for the share of the fluid around it, whose C_a is
 * not exactly 1/2 on a mesh. With C_v on the contact the body would have (rho_r
 * + 1/2)/(rho_r + 2) of it at first. */
FACT_FOR_EACH(ew18_2_a_push_moves_a_body_at_once, 3)
{
    static const double rho[3] = {0.1, 1.0, 8.0};
    const struct body_shape sphere = body_shape_sphere(0.5);
    const double m = M_PI / 6.0 * 0.125, P = 1e-3 * m;
    struct pool p;

    pool_at_rest(&p, &sphere, rho[_i]);
    struct particles *const ps = p.bodies->ps;
    ps->vy[0] += P / (ps->m[0] + ps->added_mass[0]);
    const double first = ps->vy[0];
    ck_assert_double_eq_tol(first, P / ((rho[_i] + 0.5) * m), 1e-12 * first);
    pool_run(&p, 20);
    ck_assert_double_eq_tol(ps->vy[0], first, 0.25 * first / (rho[_i] + 0.5));
    pool_free(&p);
}

/* I omega is the impulse, with the inertia of the solid alone, because a sphere
 * that spins moves a thin fluid hardly: on a mesh some of the cells beside it,
 * which is 0.05 of the displaced fluid. Were what contacts change
 * counted among what C_v delays, the spin would become 1 + C_v/rho_r times as
 * large. */
FACT_FOR_EACH(ew18_3_the_spin_that_a_contact_gives_a_sphere_stays, 3)
{
    static const double rho[3] = {0.1, 1.0, 8.0};
    const struct body_shape sphere = body_shape_sphere(0.5);
    const double I = 0.4 * rho[_i] * M_PI / 6.0 * 0.125 * 0.0625;
    struct pool p;

    pool_at_rest(&p, &sphere, rho[_i]);
    struct particles *const ps = p.bodies->ps;
    body_motion_add_spin(p.bodies, 0, (double[3]){0.0, 0.0, 1e-3 * I});
    ck_assert_double_eq_tol(ps->wz[0], 1e-3, 1e-15);
    pool_run(&p, 20);
    ck_assert_double_lt(ps->wz[0], 1e-3);
    ck_assert_double_gt(ps->wz[0], 1e-3 * rho[_i] / (rho[_i] + 0.06));
    pool_free(&p);
}

/* A cube also turns some fluid around it, 0.18 of what it displaces. Its
 * contacts act on it with 0.5 of that, and what is too much comes back. */
FACT_FOR_EACH(ew18_3_the_spin_that_a_contact_gives_a_cube_stays, 3)
{
    static const double rho[3] = {0.5, 1.0, 8.0};
    const struct body_shape box = body_shape_box((double[3]){0.5, 0.5, 0.5}),
                            cube = body_shape_outline(block_outline_create(
                                &box, (double[3]){0.0, 0.0, 0.0}));
    struct pool p;
    double G[6];

    pool_at_rest(&p, &cube, rho[_i]);
    struct particles *const ps = p.bodies->ps;
    body_turn_gyration(p.bodies, 0, G);
    const double I = rho[_i] * 0.125 * G[5];
    body_motion_add_spin(p.bodies, 0, (double[3]){0.0, 0.0, 1e-3 * I});
    ck_assert_double_eq_tol(ps->wz[0], 1e-3 * rho[_i] / (rho[_i] + 0.5), 1e-12);
    pool_run(&p, 20);
    ck_assert_double_eq_tol(rho[_i] * (1e-3 / ps->wz[0] - 1.0), 0.18, 0.01);
    pool_free(&p);
}

/* Two spheres of different densities collide off-centre in a closed box of
 * fluid that is periodic: what they and the fluid have together stays (24.13).
 */
FACT(ew18_2_momentum_is_constant_in_a_collision)
{
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {16, 16, 16},
                                   .rho = 1.0,
                                   .mu = 1e-3,
                                   .dt = 0.005,
                                   .virtual_mass = 3.0,
                                   .dem_steps = 8,
                                   .tolerance = 1e-10,
                                   .n = 2};
    const struct body_shape sphere = body_shape_sphere(0.375);
    double sum[3], before = 0.0;
    int touched = 0;
    struct pool p;

    pool_create(&p, &o);
    p.bodies->contacts.material = (struct material){
        .stiffness = 40.0, .restitution = 0.8, .friction = 0.3};
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.3, 0.5, 0.5}, 0.3,
                     BODY_FREE);
    solid_bodies_add(p.bodies, &sphere, (double[3]){0.7, 0.56, 0.5}, 4.0,
                     BODY_FREE);
    p.bodies->ps->vx[0] = 1.0;
    p.bodies->ps->vx[1] = -1.0;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    for (int i = 0; i < 40; i++) {
        memset(sum, 0, sizeof sum);
        fluid_momentum(p.fluid, sum);
        body_motion_add_momentum(p.bodies, sum);
        if (i == 0) before = sum[0];
        ck_assert_double_eq_tol(sum[0], before, 1e-9);
        ck_assert_double_eq_tol(sum[1], 0.0, 1e-9);
        pool_run(&p, 1);
        touched += p.bodies->dem_report.contacts;
    }
    ck_assert_int_gt(touched, 4);
    pool_free(&p);
}

/* Linear and angular momentum, about the middle, that an outsider finds: of all
 * cells and of what the body has more than the fluid in its place. */
static void sum_of_cells(const struct pool *p, double P[3], double L[3])
{
    for (int k = 0; k < 3; k++)
        P[k] = L[k] = 0.0;
    for (int c = 0; c < p->mesh->n_cells; c++) {
        const double m = p->fluid->options.rho * p->mesh->V[c];
        double r[3], turn[3];
        vector_between(&p->mesh->centre[3 * c], middle, r);
        vector_cross(r, &p->fluid->u[3 * c], turn);
        vector_along(P, m, &p->fluid->u[3 * c], P);
        vector_along(L, m, turn, L);
    }
}

/* Launched in a fluid at rest, a body has m U and I omega, and nothing else has
 * any; the fluid in its place, which it is not, has what is missing to that.
 * When viscosity has brought all to one velocity, it is m U over the mass of
 * all. */
FACT_FOR_EACH(ew18_2_a_body_that_is_launched_keeps_its_momentum, 4)
{
    const double rho[4] = {2.0, 0.1, 8.0, 2.0}, U[3] = {1.0, 0.3, -0.2};
    const struct body_shape box = body_shape_box((double[3]){0.4, 0.3, 0.35});
    const struct body_ball ball[2] = {{{0.0, 0.0, 0.0}, 0.16},
                                      {{0.2, 0.03, 0.0}, 0.12}};
    const struct body_shape shape =
        _i < 2
            ? body_shape_sphere(0.4)
            : body_shape_outline(_i < 3 ? block_outline_create(
                                              &box, (double[3]){0.2, 0.0, 0.4})
                                        : clump_create(2, ball));
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {12, 12, 12},
                                   .rho = 1.0,
                                   .mu = 0.2,
                                   .dt = 0.01,
                                   .time = _i % 2 ? "euler" : "bdf2",
                                   .virtual_mass = 2.0,
                                   .n = 1};
    double P[3], L[3], G[6], Gw[3];
    struct pool p;

    pool_create(&p, &o);
    solid_bodies_add(p.bodies, &shape, middle, rho[_i], BODY_FREE);
    struct particles *const ps = p.bodies->ps;
    const double V = p.bodies->volume[0], w[3] = {0.0, 0.0, 2.0};
    ps->vx[0] = U[0], ps->vy[0] = U[1], ps->vz[0] = U[2], ps->wz[0] = w[2];
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    sum_of_cells(&p, P, L);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(P[k], V * U[k], 1e-12);
    if (shape.kind == BODY_OUTLINE) {
        body_turn_gyration(p.bodies, 0, G);
        body_turn_times(G, w, Gw);
        ck_assert_double_eq_tol(L[2], V * Gw[2], 1e-12);
    }
    pool_run(&p, 300);
    ck_assert_double_eq_tol(ps->vx[0],
                            rho[_i] * V / (1.0 + (rho[_i] - 1.0) * V), 1e-5);
    pool_free(&p);
}

/* Speed after an impact on a wall that lasts 8 steps, over that before it, of a
 * dry sphere without losses in a thin fluid. */
static double rebound(double rho_r, double C_v)
{
    enum { N = 16 };
    const struct pool_options o = {.size = {1.0, 1.0, 1.0},
                                   .cells = {N, N, N},
                                   .walls = {0, 1, 0},
                                   .rho = 1.0,
                                   .mu = 1e-5,
                                   .dt = 0.005,
                                   .virtual_mass = C_v,
                                   .dem_steps = 8,
                                   .tolerance = 1e-6,
                                   .n = 1};
    const double d = 6.0 / N, V = M_PI / 6.0 * d * d * d, t = 8.0 * o.dt,
                 x[3] = {0.5, 0.55 * d, 0.5};
    const struct body_shape sphere = body_shape_sphere(d);
    double before = 0.0;
    struct pool p;

    pool_create(&p, &o);
    p.bodies->contacts.material = (struct material){
        .stiffness = (rho_r + 0.5) * V * M_PI * M_PI / (t * t),
        .restitution = 1.0};
    const int i = solid_bodies_add(p.bodies, &sphere, x, rho_r, BODY_FREE);
    const struct particles *const ps = p.bodies->ps;
    ps->vy[i] = -d;
    ck_assert_int_eq(solid_bodies_begin(p.bodies, p.fluid), 0);
    while (ps->vy[i] < 0.0 || ps->y[i] < 0.5 * d) {
        if (ps->y[i] > 0.5 * d) before = -ps->vy[i];
        pool_run(&p, 1);
    }
    const double after = ps->vy[i];
    pool_free(&p);
    return after / before;
}

/* With C_v = 1/2 the fluid takes 2 %. With more the reaction of the fluid to
 * the impact comes later than with that, and takes less than 2 % more; a spring
 * that acts on C_v would add 8 % and, with 8, throw the sphere back ten times
 * as fast. */
FACT(ew18_2_virtual_mass_adds_nothing_to_an_impact)
{
    const double none = rebound(8.0, 0.5);

    ck_assert_double_eq_tol(none, 0.98, 0.01);
    ck_assert_double_eq_tol(rebound(8.0, 2.0), none, 0.02);
    ck_assert_double_eq_tol(rebound(8.0, 8.0), none, 0.04);
}
