/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Rigid bodies of balls: their moments, impacts, motion and energy. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/statistics.h"
#include "dem/clumps.h"
#include "dem/dem_method.h"
#include "facts.h"
#include "kept.h"
#include "resolved/shapes/shapes.h"
#include "spheres.h"

/* A shape of balls x y z R. */
static struct clump_shape shape_of(int n, const double given[][4])
{
    struct body_ball ball[4] = {{.R = 0.0}};
    struct clump_shape s = {.name = "a clump"};

    for (int k = 0; k < n; k++)
        ball[k] = (struct body_ball){{given[k][0], given[k][1], given[k][2]},
                                     given[k][3]};
    struct body_outline *const o = clump_create(n, ball);
    struct clump_ball *const own = calloc(4, sizeof *own);
    for (int k = 0; k < n; k++) {
        memcpy(own[k].at, o->ball[k].at, sizeof own[k].at);
        own[k].R = o->ball[k].R;
    }
    ck_assert_int_eq(clumps_shape_make(&s, n, own, o->volume, o->gyration), 0);
    for (int k = 0; k < n; k++) /* they are where they were given */
        ck_assert_double_eq_tol(vector_length(own[k].at),
                                vector_length(o->ball[k].at), 2e-6);
    body_outline_free(o);
    return s;
}

/* Centres s d apart along a line that is no axis of the frame, d = 1. */
static struct clump_shape dumb_bell(double s)
{
    const double a = 0.3 * s, b = 0.4 * s;
    return shape_of(2,
                    (const double[2][4]){{-a, 0.0, b, 0.5}, {a, 0.0, -b, 0.5}});
}

static struct clump_shape lopsided(void)
{
    return shape_of(3, (const double[3][4]){{0.0, 0.0, 0.0, 0.5},
                                            {0.5, 0.1, 0.0, 0.4},
                                            {0.1, 0.6, 0.2, 0.3}});
}

/* Two truncated balls, or two whole ones: V, and I/m of the long axis and of
 * those across. 1e-5 is what the columns of the union leave. */
FACT_FOR_EACH(dumb_bells_have_the_volume_and_the_moments_of_their_union, 2)
{
    static const double exact[2][4] = {{0.5, 0.883572934, 0.10625, 0.184375},
                                       {1.0, M_PI / 3.0, 0.1, 0.35}};
    const struct clump_shape s = dumb_bell(exact[_i][0]);
    const double *const I = s.gyration;

    ck_assert_double_eq_tol(s.volume / exact[_i][1], 1.0, 1e-5);
    ck_assert_double_eq_tol(fmin(I[0], fmin(I[1], I[2])) / exact[_i][2], 1.0,
                            1e-5);
    ck_assert_double_eq_tol(fmax(I[0], fmax(I[1], I[2])) / exact[_i][3], 1.0,
                            1e-5);
    ck_assert_double_eq_tol(
        (I[0] + I[1] + I[2]) / (exact[_i][2] + 2.0 * exact[_i][3]), 1.0, 1e-5);
    free(s.ball);
}

/* Without it gravity, which acts on each ball, would turn a clump. */
FACT(shares_of_the_balls_have_the_centre_of_mass)
{
    const struct clump_shape s = lopsided();
    double sum = 0.0, centre[3] = {0.0};

    for (int k = 0; k < s.n; k++) {
        sum += s.ball[k].share;
        vector_along(centre, s.ball[k].share, s.ball[k].at, centre);
    }
    ck_assert_double_eq_tol(sum, 1.0, 1e-14);
    ck_assert_double_lt(vector_length(centre), 1e-14);
    free(s.ball);
}

static const double rest[3] = {0.0, 0.0, 0.0};

static struct dem_options loop_of(int method, double step)
{
    struct dem_options o = spheres_options(&contact_linear, step, 4.0);

    o.method = dem_methods[method];
    return o;
}

static void run(struct dem *dem, int steps)
{
    struct dem_report r;
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    ck_assert_double_lt(r.max_overlap, 0.25); /* not that of one's own balls */
}

/* On the top of a sphere that nothing moves falls one ball of a dumb-bell of
 * tangent balls, at an angle to the plane of contact: J = (1 + e) m_eff V, so
 * V'/V = -1 + (1 + e) m_eff/M [exact]. 2e-4: what it turns in the contact. With
 * the mass of the ball, or the whole mass, in the dashpot the first would be
 * 0.058 or 0.019. */
FACT_FOR_EACH(an_impact_off_the_centre_has_the_restitution_of_the_law, 6)
{
    static const double exact[3][2] = {
        {0.0, 0.050000}, {45.0, 0.326316}, {75.0, 0.717806}};
    struct clump_shape s = dumb_bell(1.0);
    struct dem_options o = loop_of(_i / 3, 1e-8);
    struct particles *const ps = particles_create(3);
    const double angle = exact[_i % 3][0] * M_PI / 180.0;
    double q[4], t[4], turn[4];

    o.material.restitution = 0.8;
    o.material.stiffness = 1e11;
    clumps_add_to(ps, 1, &s);
    spheres_add(ps, 0.0, -0.5, 0.0, 1.0);
    ps->m[0] = 1e12;
    clumps_turn((const double[3]){0.0, -atan2(0.4, 0.3), 0.0}, q);
    clumps_turn((const double[3]){0.0, 0.0, angle}, t);
    rotation_product(t, q, turn);
    clumps_add(ps, 0, 1.0, 2000.0,
               (const double[3]){0.5 * cos(angle), 0.5 + 0.5 * sin(angle), 0.0},
               (const double[3]){0.0, -1.0, 0.0}, turn, rest);
    struct dem *const dem = dem_create(ps, &o);
    run(dem, 50000);
    ck_assert_double_eq_tol(ps->clumps->item[0].v[1], exact[_i % 3][1], 2e-4);
    dem_free(dem);
    particles_free(ps);
    free(s.ball);
}

/* So many on a lattice, turned at random, that fly towards the middle of the
 * floor, all with spin; single spheres among them. */
static struct particles *swarm(const struct clump_shape *s, double speed)
{
    struct particles *const ps = particles_create(64);

    clumps_add_to(ps, 2, s);
    for (int i = 0; i < 18; i++) {
        const double x[3] = {1.6 * (i % 3) - 1.6, 1.7 * (i / 9) - 3.1,
                             1.6 * (i / 3 % 3) - 1.6};
        const double v[3] = {-speed * x[0], -speed, -speed * x[2]};
        const double w[3] = {0.3 * speed * i, speed, -speed};
        double q[4];
        clumps_turn_at_random(7, i, q);
        if (i % 5 == 4)
            spheres_throw(ps, spheres_add(ps, x[0], x[1], x[2], 0.9), v[0],
                          v[1], v[2]);
        else
            clumps_add(ps, i % 2, 0.9, 2000.0, x, v, q, w);
    }
    for (int i = 0; i < ps->n; i++)
        ps->ey[i] = -9.81 * ps->m[i];
    return ps;
}

static void two_shapes(struct clump_shape s[2])
{
    s[0] = dumb_bell(0.5);
    s[1] = lopsided();
}

static void two_shapes_free(struct clump_shape s[2])
{
    free(s[0].ball);
    free(s[1].ball);
}

/* Where nothing acts, L is never computed anew. */
FACT(a_clump_in_flight_keeps_its_angular_momentum_to_the_last_bit)
{
    struct clump_shape s[2];
    two_shapes(s);
    struct particles *const ps = particles_create(3);
    struct dem_options o = loop_of(0, 1e-3);
    const double v[3] = {1.0, -0.3, 0.2}, w[3] = {3.0, -2.0, 5.0};
    double q[4];

    o.periodic[0] = o.periodic[1] = o.periodic[2] = 1;
    clumps_add_to(ps, 2, s);
    clumps_turn_at_random(1, 1, q);
    clumps_add(ps, 1, 1.0, 2000.0, rest, v, q, w);
    const struct clump before = ps->clumps->item[0];
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 20; k++)
        run(dem, 1000);
    const struct clump *const now = &ps->clumps->item[0];
    ck_assert_mem_eq(now->L, before.L, sizeof before.L);
    ck_assert_mem_eq(now->v, before.v, sizeof before.v);
    ck_assert_double_gt(fabs(now->q[1] - before.q[1]), 0.01);
    dem_free(dem);
    particles_free(ps);
    two_shapes_free(s);
}

/* With friction, rolling friction, walls and a period: the two loops add in
 * another order, so rounding is left. */
FACT_FOR_EACH(the_fast_loop_moves_clumps_as_the_reference_does, 2)
{
    struct clump_shape s[2];
    struct particles *ps[2];
    two_shapes(s);

    for (int k = 0; k < 2; k++) {
        struct dem_options o = loop_of(k, 1e-4);
        o.material.stiffness = 1e6;
        o.material.restitution = 0.6;
        o.material.friction = 0.3;
        o.material.rolling = 0.05;
        o.periodic[0] = _i;
        ps[k] = swarm(s, 1.0);
        struct dem *const dem = dem_create(ps[k], &o);
        dem_start_energy_budget(dem);
        run(dem, 3000);
        const struct energy *const e = dem_energy(dem);
        ck_assert_double_gt(e->damped_n, 0.01 * e->kinetic);
        ck_assert_double_gt(e->slid, 0.0);
        dem_free(dem);
    }
    for (int i = 0; i < ps[0]->n; i++) {
        const int j = spheres_place(ps[1], ps[0]->id[i]);
        const double v = fabs(ps[0]->vy[i]) + 0.1;
        ck_assert_double_eq_tol(ps[0]->x[i], ps[1]->x[j], 1e-7);
        ck_assert_double_eq_tol(ps[0]->y[i], ps[1]->y[j], 1e-7);
        ck_assert_double_eq_tol(ps[0]->vy[i], ps[1]->vy[j], 1e-6 * v);
        ck_assert_double_eq_tol(ps[0]->wx[i], ps[1]->wx[j], 1e-6);
    }
    particles_free(ps[0]);
    particles_free(ps[1]);
    two_shapes_free(s);
}

/* All that is gained and lost is counted: what is left is of the second order
 * in the step. 3e-5 of the kinetic energy; without the torque of the contacts
 * it would be a tenth. */
FACT_FOR_EACH(the_energy_budget_of_clumps_closes, 2)
{
    struct clump_shape s[2];
    two_shapes(s);
    struct dem_options o = loop_of(_i, 1e-4);
    struct particles *const ps = swarm(s, 1.0);

    o.material.stiffness = 1e6;
    o.material.restitution = 0.6;
    o.material.friction = 0.3;
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    run(dem, 4000);
    const struct energy *const e = dem_energy(dem);
    ck_assert_double_gt(e->damped_n, 0.05 * e->kinetic);
    ck_assert_double_lt(fabs(energy_residual(e)), 3e-5 * e->kinetic);
    dem_free(dem);
    particles_free(ps);
    two_shapes_free(s);
}

FACT_FOR_EACH(any_number_of_threads_and_a_restart_give_the_same_bits, 4)
{
    static const int threads[4] = {1, 2, 3, 7};
    struct clump_shape s[2];
    struct particles *ps[2];
    two_shapes(s);

    for (int k = 0; k < 2; k++) {
        struct dem_options o = loop_of(0, 1e-4);
        o.material.stiffness = 1e6;
        o.material.friction = 0.3;
        omp_set_num_threads(k == 0 ? 1 : threads[_i]);
        ps[k] = swarm(s, 1.0);
        struct dem *dem = dem_create(ps[k], &o);
        run(dem, 1500);
        if (k == 1) {
            struct kept *const kept = kept_create();
            particles_state(ps[k], &kept->state);
            dem_state(dem, &kept->state);
            dem_free(dem);
            particles_free(ps[k]);
            ps[k] = swarm(s, 0.5);
            dem = dem_create(ps[k], &o);
            particles_state(ps[k], kept_load(kept));
            dem_state(dem, &kept->state);
            ck_assert_int_eq(kept->state.failed, 0);
            kept_free(kept);
        }
        run(dem, 1500);
        dem_free(dem);
    }
    omp_set_num_threads(1);
    for (int i = 0; i < ps[0]->n; i++)
        ck_assert_int_eq(ps[0]->id[i], ps[1]->id[i]);
    ck_assert_mem_eq(ps[0]->clumps->item, ps[1]->clumps->item,
                     (size_t)ps[0]->clumps->n * sizeof *ps[0]->clumps->item);
    ck_assert_mem_eq(ps[0]->wx, ps[1]->wx,
                     (size_t)ps[0]->n * sizeof *ps[0]->wx);
    for (int k = 0; k < 2; k++)
        particles_free(ps[k]);
    two_shapes_free(s);
}

FACT(a_clump_leaves_with_all_its_balls)
{
    struct clump_shape s[2];
    two_shapes(s);
    struct particles *const ps = swarm(s, 1.0);
    const int n = ps->n, clumps = ps->clumps->n;
    int removed[64] = {0};

    removed[4] = 1; /* of the second clump, which has three */
    clumps_mark(ps, removed);
    particles_remove(ps, removed);
    ck_assert_int_eq(ps->n, n - 3);
    ck_assert_int_eq(ps->clumps->n, clumps - 1);
    for (int i = 0; i < ps->n; i++) {
        const int of = ps->clumps->of[ps->id[i]];
        if (of < 0) continue;
        const int k = ps->id[i] - ps->clumps->item[of].first;
        ck_assert_int_ge(k, 0);
        ck_assert_int_lt(k, s[ps->clumps->item[of].shape].n);
    }
    particles_free(ps);
    two_shapes_free(s);
}
