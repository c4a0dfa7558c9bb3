/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Manufactured solutions of the averaged equations, between walls, with a fluid
 * fraction that varies in space and time: the orders of convergence. */
#include "facts.h"
#include "manufactured.h"

static struct manufactured setting(int i)
{
    static const struct manufactured rows[] = {
        {.kind = MANUFACTURED_BOX, .shared = 0, .mixture = 0},
        {.kind = MANUFACTURED_BOX, .shared = 1, .mixture = 1, .K = 20.0},
        {.kind = MANUFACTURED_BOX, .shared = 1, .mixture = 0, .grading = 3.0},
        {.kind = MANUFACTURED_BOX, .shared = 0, .mixture = 1, .shear = {0.4}},
        {.kind = MANUFACTURED_CHANNEL,
         .shared = 1,
         .mixture = 1,
         .grading = 3.0},
        {.kind = MANUFACTURED_CHANNEL, .shared = 0, .mixture = 0, .K = 20.0}};
    struct manufactured a = rows[i];

    a.flat = 1;
    a.time = "bdf2";
    a.convection = "linear";
    a.end = 0.32;
    return a;
}

static struct manufactured_error run(struct manufactured a, int n)
{
    a.n = n;
    a.dt = a.end / n;
    return manufactured_run(&a);
}

/* Step and mesh halved together: the velocity falls by four, the largest error
 * and the one at the walls, too. The pressure is that of the cell at a wall and
 * falls less there (Chapter "The flow, verified"). */
FACT_FOR_EACH(a_flow_between_walls_has_order_two_in_u_and_more_than_one_in_p, 6)
{
    const struct manufactured_error a = run(setting(_i), 12),
                                    b = run(setting(_i), 24);
    ck_assert_double_gt(log2(a.u / b.u), 1.8);
    ck_assert_double_gt(log2(a.u_wall / b.u_wall), 1.5);
    ck_assert_double_gt(log2(a.u_max / b.u_max), 1.5);
    ck_assert_double_gt(log2(a.p / b.p), 1.3);
    ck_assert_double_lt(b.u, 0.015);
}

/* All at once: three directions, graded and sheared, walls on all sides. */
FACT_FOR_EACH(so_it_has_in_three_dimensions_graded_and_sheared, 2)
{
    struct manufactured a = setting(2);
    a.flat = 0;
    a.mixture = _i;
    a.shear[0] = 0.3;
    a.shear[1] = 0.2;
    a.shear[2] = -0.3;
    a.end = 0.16;
    const struct manufactured_error coarse = run(a, 6), fine = run(a, 12);
    ck_assert_double_gt(log2(coarse.u / fine.u), 1.7);
    ck_assert_double_gt(log2(coarse.p / fine.p), 1.0);
}

/* The number of correctors that reduce the momentum residual to 1e-6, at the
 * end of five steps in which viscosity crosses a cell. */
static int correctors(double shear)
{
    struct manufactured a = setting(3);
    struct manufactured_boundaries b;

    a.shear[0] = shear;
    a.time = "euler";
    a.n = 20;
    a.dt = 0.025; /* nu dt / dx^2 = 1 */
    struct fluid *const fl = manufactured_create(&a, &b);
    for (int i = 0; i < 5; i++) {
        manufactured_set(&a, fl, fl->t + a.dt);
        ck_assert_int_eq(fluid_step(fl), 0);
        ck_assert_double_le(fl->report.piso_residual, 1e-6);
    }
    const int most = fl->report.correctors;
    mesh_free((struct mesh *)fl->mesh);
    owner_free(fl);
    return most;
}

/* Links 27 and 45 degrees oblique: the oblique part of the pressure's gradient
 * lags behind by a factor of s / sqrt(1 + s^2) a corrector, 0.45 and 0.71,
 * which is hardly slower than the rest. Taken from the corrector before it
 * would grow from s = 0.35 on. */
FACT(non_orthogonal_links_need_few_more_correctors)
{
    const int straight = correctors(0.0);
    ck_assert_int_le(correctors(0.5), straight + straight / 4);
    ck_assert_int_le(correctors(1.0), straight + straight / 2);
}

/* The oblique part of the viscous stress is taken from what is known. The
 * extrapolation of BDF2 would grow where viscosity crosses cells within a step:
 * by x with x^2 + 2 r x - r = 0, r = 0.71 at 45 degrees. */
FACT(two_step_schemes_are_stable_on_non_orthogonal_links)
{
    struct manufactured a = setting(3);
    a.steady = 1;
    a.shear[0] = 1.0;
    a.n = 16;
    a.dt = 0.4; /* nu dt / dx^2 = 10 */
    a.end = 40.0 * a.dt;
    ck_assert_double_lt(manufactured_run(&a).u, 0.05);
}

FACTS
{
    tcase_set_timeout(facts, 120.0);
}
