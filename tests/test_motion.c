/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Walls and particles that move as prescribed. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/surface.h"
#include "dem/surfaces/surfaces.h"
#include "dem/surfaces/prescribed_particles.h"
#include "facts.h"
#include "spheres.h"

static const double g = 9.81; /* [m/s^2] */

static struct surface plate(const struct motion *m)
{
    const struct surface s = {.name = "plate",
                              .shape = &surface_plane,
                              .normal = {0.0, 1.0, 0.0},
                              .motion = *m};
    return s;
}

/* The same plate as two triangles. */
static struct surface sheet(const struct motion *m)
{
    double corner[2][3][3] = {{{-3, 0, -3}, {3, 0, -3}, {3, 0, 3}},
                              {{-3, 0, -3}, {3, 0, 3}, {-3, 0, 3}}};
    const struct surface s = {.name = "sheet",
                              .shape = &surface_stl,
                              .triangles = triangles_create(2, corner),
                              .motion = *m};
    return s;
}

static void forget(struct surface *s)
{
    owner_free((struct triangles *)(uintptr_t)s->triangles);
}

static struct dem_options with(const struct surface *s, double step)
{
    struct dem_options o = spheres_options(&contact_linear, step, 2.0);

    o.material.restitution = 0.5;
    o.material.friction = 0.8;
    o.surfaces = s;
    o.n_surfaces = s != NULL;
    return o;
}

/* One sphere of 0.1 m with its centre at x, y, 0. */
static struct particles *sphere_at(double x, double y, double weight)
{
    struct particles *const ps = particles_create(2);

    spheres_add(ps, x, y, 0.0, 0.1);
    ps->ey[0] = -weight * g * ps->m[0];
    return ps;
}

/* Its overlap at rest on a plate [m]. */
static double sag(const struct particles *ps)
{
    return ps->m[0] * g / 1e4;
}

static struct dem *started(struct particles *ps, const struct dem_options *o)
{
    struct dem *const dem = dem_create(ps, o);

    ck_assert_ptr_nonnull(dem);
    dem_clock(dem, 0);
    return dem;
}

/* --- the motion itself ---------------------------------------------------- */

static const struct motion all_at_once = {.from = 0.2,
                                          .until = 1.7,
                                          .velocity = {0.1, -0.2, 0.3},
                                          .amplitude = {0.05, 0.02, 0.0},
                                          .frequency = 1.5,
                                          .centre = {0.3, 0.1, -0.2},
                                          .spin = {0.5, 1.0, -2.0}};

/* Central differences, 1e-5 s: their error is about 1e-9. */
FACT(velocity_of_a_motion_is_its_derivative)
{
    const double start[3] = {1.0, 2.0, -0.5}, h = 1e-5;

    for (double t = 0.0; t < 2.0; t += 0.0611) {
        const struct pose p = motion_pose(&all_at_once, t);
        const struct pose a = motion_pose(&all_at_once, t - h);
        const struct pose b = motion_pose(&all_at_once, t + h);
        double x[3], before[3], after[3], v[3];
        motion_place(&p, start, x);
        motion_place(&a, start, before);
        motion_place(&b, start, after);
        motion_velocity(&p, x, v);
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(v[k], (after[k] - before[k]) / (2.0 * h),
                                    1e-7);
        ck_assert_double_le(vector_length(v), motion_speed(&all_at_once, 3.0));
    }
}

FACT(motion_leaves_distances_and_finds_back)
{
    const double one[3] = {1.0, 2.0, -0.5}, two[3] = {-0.4, 0.1, 0.7};
    const struct pose p = motion_pose(&all_at_once, 1.234);
    double x[3], y[3], back[3], apart[3], before[3];

    motion_place(&p, one, x);
    motion_place(&p, two, y);
    motion_origin(&p, x, back);
    vector_between(x, y, apart);
    vector_between(one, two, before);
    ck_assert_double_eq_tol(vector_length(apart), vector_length(before), 1e-14);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(back[k], one[k], 1e-14);
}

/* --- a table of it -------------------------------------------------------- */

static struct motion_table *table_of(const char *text, int repeat)
{
    const struct input in = {.text = (char *)(uintptr_t)text,
                             .length = strlen(text)};
    char wrong[CSV_WRONG];
    return motion_table_create(&in, repeat, wrong);
}

static const char places[] = "t [s],x [m],z [m]\n0,3,1\n0.5,4,1\n2,3.1,-2\n",
                  velocities[] = "t v_y\n0 0\n1 4\n3 0\n3.5 0\n";

/* Every row is met, half of the way between two is at half of the time, and
 * what counts is the way from the first row. After the last it rests. */
FACT(a_table_of_places_is_linear_between_its_rows)
{
    struct motion_table *const table = table_of(places, 0);
    const struct motion m = {
        .from = 1.0, .velocity = {0.0, 2.0, 0.0}, .table = table};
    const double at[][5] = {{0.0, 0, 0, 0, 0},
                            {1.0, 0, 0, 2, 0},
                            {1.25, 0.5, 0, 2, 0},
                            {1.5, 1, 0, -0.6, -2},
                            {2.25, 0.55, -1.5, -0.6, -2},
                            {3.0, 0.1, -3, 0, 0},
                            {9.0, 0.1, -3, 0, 0}};

    for (int i = 0; i < 7; i++) {
        const struct pose p = motion_pose(&m, at[i][0]);
        ck_assert_double_eq_tol(p.centre[0], at[i][1], 1e-15);
        ck_assert_double_eq(p.centre[1], 2.0 * fmax(at[i][0] - 1.0, 0.0));
        ck_assert_double_eq_tol(p.centre[2], at[i][2], 1e-15);
        ck_assert_double_eq_tol(p.velocity[0], at[i][3], 1e-15);
        ck_assert_double_eq_tol(p.velocity[2], at[i][4], 1e-15);
    }
    free(table);
}

/* v = 4 t until 1 s, and falls to 0 until 3 s: ways of 2 and 4 m. */
FACT(the_way_of_a_table_of_velocities_is_their_integral)
{
    struct motion_table *const table = table_of(velocities, 0);
    const struct motion m = {.table = table};
    const double at[][3] = {{0.5, 0.5, 2.0}, {1.0, 2.0, 4.0}, {2.0, 5.0, 2.0},
                            {3.0, 6.0, 0.0}, {3.2, 6.0, 0.0}, {4.0, 6.0, 0.0}};

    for (int i = 0; i < 6; i++) {
        const struct pose p = motion_pose(&m, at[i][0]);
        ck_assert_double_eq_tol(p.centre[1], at[i][1], 1e-15);
        ck_assert_double_eq_tol(p.velocity[1], at[i][2], 1e-15);
    }
    ck_assert_double_eq(motion_speed(&m, 1.0), 4.0);
    free(table);
}

/* A repeated table begins again from where it is: after n times it has gone n
 * times its way, without a jump. Its velocity is its derivative. */
FACT_FOR_EACH(a_repeated_table_goes_on_from_where_it_is, 2)
{
    const double way = _i ? 6.0 : 0.1, length = _i ? 3.5 : 2.0, h = 1e-7;
    struct motion_table *const table = table_of(_i ? velocities : places, 1);
    const struct motion m = {.table = table};
    const int k = _i ? 1 : 0;

    for (int n = 0; n < 5; n++)
        for (double s = 0.01; s < length; s += 0.123) {
            const double t = n * length + s;
            const struct pose p = motion_pose(&m, t), q = motion_pose(&m, s);
            const struct pose a = motion_pose(&m, t - h);
            const struct pose b = motion_pose(&m, t + h);
            ck_assert_double_eq_tol(p.centre[k], n * way + q.centre[k], 1e-13);
            ck_assert_double_eq_tol(
                p.velocity[k], (b.centre[k] - a.centre[k]) / (2 * h), 1e-6);
        }
    for (int n = 1; n < 5; n++) {
        const struct pose a = motion_pose(&m, n * length - h);
        const struct pose b = motion_pose(&m, n * length + h);
        ck_assert_double_le(fabs(b.centre[k] - a.centre[k]), 5.0 * h);
    }
    free(table);
}

FACT(a_table_that_is_no_motion_is_refused)
{
    static const char *const wrong[] = {"t,x\n0,0\n",
                                        "t,x\n0.1,0\n1,1\n",
                                        "t,x\n0,0\n0,1\n",
                                        "t,x\n0,0\n1,nan\n",
                                        "t,x\n0,0\n1,1e13\n",
                                        "x,y\n0,0\n1,1\n",
                                        "t,x,v_y\n0,0,0\n1,1,1\n",
                                        "t,x,q\n0,0,0\n1,1,1\n",
                                        "t,x [mm]\n0,0\n1,1\n",
                                        "t [ms],x\n0,0\n1,1\n",
                                        "t\n0\n1\n",
                                        "t,x\n0,0\n1e-9,1e12\n"};

    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        ck_assert_msg(table_of(wrong[i], 0) == NULL, "%s", wrong[i]);
}

/* One slope is a constant velocity: the same wall throws the same sphere, and
 * the same particle pushes it. */
FACT_FOR_EACH(a_table_of_one_slope_is_a_velocity, 2)
{
    struct motion_table *const table = table_of("t v_y\n0 0.5\n9 0.5\n", 0);
    const struct motion m[2] = {{.velocity = {0.0, 0.5, 0.0}},
                                {.table = table}};
    double v[2], w[2];

    for (int k = 0; k < 2; k++) {
        struct surface s = plate(&m[k]);
        const struct prescribed_particle one = {.id = 1, .motion = m[k]};
        struct dem_options o = with(_i ? NULL : &s, 2e-4);
        struct particles *const ps = sphere_at(0.2, 0.1, 0.0);
        struct dem_report r;
        if (_i) {
            spheres_add(ps, 0.23, -0.1, 0.0, 0.1);
            o.prescribed = &one;
            o.n_prescribed = 1;
        }
        struct dem *const dem = started(ps, &o);
        ck_assert_int_eq(dem_run(dem, 2000, &r), 0);
        v[k] = ps->vy[spheres_place(ps, 0)];
        w[k] = ps->wz[spheres_place(ps, 0)];
        dem_free(dem);
        particles_free(ps);
    }
    ck_assert_double_gt(v[0], 0.5);
    ck_assert_double_eq_tol(v[1], v[0], 1e-9);
    ck_assert_double_eq_tol(w[1], w[0], 1e-9);
    free(table);
}

/* --- walls ------------------------------------------------------------------
 */

/* A moving wall gives (1 + e) V to a sphere that it hits; a triangle or a
 * plane. The step is a 1000th of the contact, whose damping costs it 1e-3 of
 * e. */
FACT_FOR_EACH(moving_wall_throws_a_sphere_at_one_plus_e_times_its_speed, 2)
{
    const struct motion m = {.velocity = {0.0, 0.5, 0.0}};
    struct surface s = _i ? sheet(&m) : plate(&m);
    const struct dem_options o = with(&s, 2e-5);
    struct particles *const ps = sphere_at(0.2, 0.1, 0.0);
    struct dem *const dem = started(ps, &o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(dem, 10000, &r), 0);
    ck_assert_double_eq_tol(ps->vy[0], 0.75, 1e-3);
    ck_assert_double_eq_tol(dem_surface(dem, 0).work, ps->m[0] * 0.75 * 0.5,
                            1e-3 * ps->m[0]);
    dem_free(dem);
    particles_free(ps);
    forget(&s);
}

/* It rests until the clock is started, and before `from`. */
FACT(a_moving_wall_is_at_rest_before_its_start)
{
    const struct motion m = {.from = 1.0, .velocity = {0.0, 0.5, 0.0}};
    struct surface s = plate(&m);
    const struct dem_options o = with(&s, 1e-3);
    struct particles *const ps = sphere_at(0.2, 0.5, 0.0);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    dem_run(dem, 1500, &r);
    ck_assert_double_eq(dem_surface(dem, 0).pose.centre[1], 0.0);
    dem_clock(dem, 0);
    dem_run(dem, 900, &r);
    ck_assert_double_eq(dem_surface(dem, 0).pose.centre[1], 0.0);
    dem_run(dem, 200, &r);
    ck_assert_double_eq_tol(dem_surface(dem, 0).pose.centre[1], 0.05, 1e-12);
    dem_free(dem);
    particles_free(ps);
}

/* A solid sphere that rolls on a moving plate has 2/7 of the velocity of the
 * plate, as its inertia is 2/5 m R^2. The plate swings slowly beside the
 * contact's own frequency. */
FACT_FOR_EACH(sphere_follows_a_swinging_plate_at_two_sevenths, 2)
{
    const struct motion m = {.amplitude = {0.02, 0.0, 0.0}, .frequency = 1.0};
    struct surface s = _i ? sheet(&m) : plate(&m);
    const struct dem_options o = with(&s, 5e-5);
    struct particles *const ps = sphere_at(0.2, 0.0, 1.0);
    const double V = 0.02 * 2.0 * M_PI;

    ps->y[0] = 0.05 - sag(ps);
    spheres_throw(ps, 0, 2.0 / 7.0 * V, 0.0, 0.0); /* as if it always had */
    spheres_spin(ps, 0, 0.0, 0.0, 5.0 / 7.0 * V / 0.05);
    struct dem *const dem = started(ps, &o);
    struct dem_report r;
    for (int k = 1; k <= 40; k++) {
        ck_assert_int_eq(dem_run(dem, 1000, &r), 0);
        ck_assert_double_eq_tol(
            ps->vx[0], 2.0 / 7.0 * V * cos(2.0 * M_PI * 0.05 * k), 0.01 * V);
    }
    dem_free(dem);
    particles_free(ps);
    forget(&s);
}

/* On a turntable a sphere rolls in a circle, at 2/7 of the table's rate, from
 * wherever it is and at whatever speed it starts. */
FACT_FOR_EACH(sphere_on_a_turntable_circles_at_two_sevenths_of_its_rate, 2)
{
    const struct motion m = {.centre = {0.1, 0.0, 0.3},
                             .spin = {0.0, 3.0, 0.0}};
    struct surface s = _i ? sheet(&m) : plate(&m);
    struct dem_options o = with(&s, 5e-5);
    struct particles *const ps = sphere_at(0.2, 0.0, 1.0);
    const double rate = 2.0 / 7.0 * 3.0, v = 0.1, R = 0.05;
    const int steps = (int)lround(2.0 * M_PI / rate / o.step);

    o.material.stiffness = 1e6; /* so that the arm is R to 1e-4 */
    ps->y[0] = R - 0.01 * sag(ps);
    spheres_throw(ps, 0, v, 0.0, 0.0);
    /* rolling: v + omega x (-R y) is the table's velocity, spin x (x - c) */
    spheres_spin(ps, 0, 0.1 * 3.0 / R, 0.0, (-0.3 * 3.0 - v) / R);
    struct dem *const dem = started(ps, &o);
    struct dem_report r;
    ck_assert_int_eq(dem_run(dem, steps / 2, &r), 0);
    ck_assert_double_eq_tol(ps->z[0], -2.0 * v / rate, 2e-3);
    ck_assert_double_eq_tol(ps->vx[0], -v, 1e-3);
    ck_assert_int_eq(dem_run(dem, steps - steps / 2, &r), 0);
    ck_assert_double_eq_tol(ps->x[0], 0.2, 2e-3);
    ck_assert_double_eq_tol(ps->z[0], 0.0, 2e-3);
    dem_free(dem);
    particles_free(ps);
    forget(&s);
}

/* In a turning drum it stays at the bottom and spins with the wall. */
FACT(sphere_in_a_drum_spins_with_the_wall)
{
    const struct surface s = {.name = "drum",
                              .shape = &surface_cylinder,
                              .normal = {0.0, 0.0, 1.0},
                              .radius = 0.5,
                              .inside = 1,
                              .motion = {.spin = {0.0, 0.0, 0.5}}};
    const struct dem_options o = with(&s, 1e-4);
    struct particles *const ps = sphere_at(0.0, -0.45, 1.0);
    struct dem *const dem = started(ps, &o);
    struct dem_report r;

    ps->wz[0] = 0.5 * 0.5 / 0.05;
    ck_assert_int_eq(dem_run(dem, 50000, &r), 0);
    ck_assert_double_eq_tol(ps->x[0], 0.0, 1e-3);
    ck_assert_double_eq_tol(ps->wz[0], 5.0, 0.05);
    dem_free(dem);
    particles_free(ps);
}

/* A sphere lies on a lift, off its centre: the lift receives the weight and its
 * torque, and does m g h of work. */
FACT_FOR_EACH(surface_accounts_for_force_torque_and_work, 2)
{
    const struct motion m = {.velocity = {0.0, 0.2, 0.0},
                             .centre = {-0.1, 0.0, 0.2}};
    struct surface s = _i ? sheet(&m) : plate(&m);
    const struct dem_options o = with(&s, 5e-5);
    struct particles *const ps = sphere_at(0.2, 0.0, 1.0);
    const double W = ps->m[0] * g;

    ps->y[0] = 0.05 - sag(ps);
    ps->vy[0] = 0.2;
    struct dem *const dem = started(ps, &o);
    struct dem_report r;
    ck_assert_int_eq(dem_run(dem, 20000, &r), 0); /* 1 s */
    const struct dem_surface a = dem_surface(dem, 0);
    ck_assert_double_eq_tol(a.impulse[1], -W, 1e-3 * W);
    ck_assert_double_eq_tol(a.impulse[0], 0.0, 1e-3 * W);
    ck_assert_double_eq_tol(a.angular[0], -0.2 * W, 1e-3 * W);
    ck_assert_double_eq_tol(a.angular[2], -0.3 * W, 1e-3 * W);
    ck_assert_double_eq_tol(a.work, W * 0.2, 1e-3 * W);
    dem_free(dem);
    particles_free(ps);
    forget(&s);
}

/* --- particles of prescribed motion ------------------------------------------
 */

FACT(prescribed_particle_is_free_and_then_circles)
{
    const struct prescribed_particle one = {
        .id = 0,
        .motion = {.from = 0.5, .centre = {0.5, 0.0, 0.0}, .spin = {0, 0, 4}}};
    struct dem_options o = with(NULL, 1e-3);
    struct particles *const ps = sphere_at(0.0, 0.0, 0.0);
    struct dem_report r;

    o.prescribed = &one;
    o.n_prescribed = 1;
    spheres_throw(ps, 0, 0.2, 0.0, 0.0);
    struct dem *const dem = started(ps, &o);
    dem_run(dem, 500, &r);
    ck_assert_double_eq_tol(ps->x[0], 0.1, 1e-12);
    ck_assert_double_eq_tol(ps->vx[0] + 1.0, 1.0, 1e-9); /* now prescribed */
    for (int k = 1; k <= 50; k++) {
        dem_run(dem, 37, &r);
        const double a = 4.0 * 0.037 * k;
        ck_assert_double_eq_tol(ps->x[0], 0.5 - 0.4 * cos(a), 1e-11);
        ck_assert_double_eq_tol(ps->y[0], -0.4 * sin(a), 1e-11);
        ck_assert_double_eq_tol(ps->vx[0], 1.6 * sin(a), 1e-9);
        ck_assert_double_eq_tol(ps->wz[0], 4.0, 1e-12);
        ck_assert_double_eq_tol(
            r.translation + r.rotation,
            0.5 * ps->m[0] * (1.6 * 1.6 + 0.4 * 0.05 * 0.05 * 16.0), 1e-9);
    }
    dem_free(dem);
    particles_free(ps);
}

/* Without a velocity it is held where it is, against a push and a throw. */
FACT(prescribed_particle_without_a_speed_is_held)
{
    const struct prescribed_particle one = {.id = 0, .motion = {.until = 0.5}};
    struct dem_options o = with(NULL, 1e-3);
    struct particles *const ps = sphere_at(0.1, 0.2, 0.3);
    struct dem_report r;

    o.prescribed = &one;
    o.n_prescribed = 1;
    spheres_throw(ps, 0, 0.2, 0.0, 0.0);
    ps->ey[0] = 1.0;
    struct dem *const dem = started(ps, &o);
    dem_run(dem, 400, &r);
    ck_assert_double_eq(ps->x[0], 0.1);
    ck_assert_double_eq(ps->y[0], 0.2);
    ck_assert_double_eq(ps->vx[0], 0.0);
    dem_run(dem, 200, &r); /* free from 0.5 s on */
    ck_assert_double_ge(ps->y[0], 0.2 + 1e-6);
    dem_free(dem);
    particles_free(ps);
}

/* A rough floor of 12 x 12 spheres that lie in a square, shaken and turned,
 * from 0.02 to 0.2 s, and 36 that fall on it. */
static struct particles *above_a_rough_floor(void)
{
    struct particles *const ps = particles_create(180);

    for (int k = 0; k < 144; k++)
        spheres_add(ps, 0.11 * (k % 12) - 0.6, -0.3 + 0.01 * (k % 7),
                    0.11 * (k / 12) - 0.6, 0.1);
    for (int k = 0; k < 36; k++) {
        const int i = spheres_add(ps, 0.17 * (k % 6) - 0.42, -0.15,
                                  0.17 * (k / 6) - 0.4, 0.08);
        spheres_throw(ps, i, 0.1, -1.0, 0.05 * (k % 5));
        ps->ey[i] = -g * ps->m[i];
    }
    return ps;
}

static const struct motion rough = {.from = 0.02,
                                    .until = 0.2,
                                    .amplitude = {0.0, 0.01, 0.0},
                                    .frequency = 20.0,
                                    .spin = {0.0, 0.5, 0.0}};

/* Runs it with as many ranges, of one sphere each or of all. */
static struct particles *on_a_rough_floor(int n, int threads)
{
    struct prescribed_particle *const all =
        alloc_zeroed((size_t)n, sizeof *all);
    struct dem_options o = with(NULL, 1e-4);
    struct particles *const ps = above_a_rough_floor();
    struct dem_report r;

    for (int k = 0; k < n; k++)
        all[k] = (struct prescribed_particle){
            .id = k, .last = n == 1 ? 143 : 0, .motion = rough};
    o.prescribed = all;
    o.n_prescribed = n;
    omp_set_num_threads(threads);
    struct dem *const dem = started(ps, &o);
    for (int k = 0; k < 30; k++)
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
    dem_free(dem);
    free(all);
    return ps;
}

/* To the bit; and in the end all of them are free. */
FACT_FOR_EACH(a_range_of_prescribed_particles_moves_as_each_of_them_alone, 2)
{
    struct particles *const one = on_a_rough_floor(1, _i + 1);
    struct particles *const many = on_a_rough_floor(144, 1);
    const size_t size = (size_t)one->n * sizeof(double);

    ck_assert_mem_eq(one->id, many->id, (size_t)one->n * sizeof(int));
    ck_assert_mem_eq(one->x, many->x, size);
    ck_assert_mem_eq(one->vy, many->vy, size);
    ck_assert_mem_eq(one->wz, many->wz, size);
    ck_assert_double_ne(one->vy[spheres_place(one, 150)], -1.0);
    particles_free(one);
    particles_free(many);
}

/* It acts on the others as a wall: (1 + e) V, although its mass is the same as
 * theirs. */
FACT(prescribed_particle_repels_another_as_a_wall_does)
{
    const struct prescribed_particle one = {
        .id = 0, .motion = {.velocity = {0.5, 0.0, 0.0}}};
    struct dem_options o = with(NULL, 2e-5);
    struct particles *const ps = sphere_at(0.0, 0.0, 1.0);
    struct dem_report r;

    o.prescribed = &one;
    o.n_prescribed = 1;
    spheres_add(ps, 0.2, 0.0, 0.0, 0.1);
    struct dem *const dem = started(ps, &o);
    ck_assert_int_eq(dem_run(dem, 20000, &r), 0);
    ck_assert_double_eq_tol(ps->vx[spheres_place(ps, 1)], 0.75, 1e-3);
    ck_assert_double_eq_tol(ps->vx[spheres_place(ps, 0)], 0.5, 1e-9);
    ck_assert_double_eq_tol(ps->y[spheres_place(ps, 0)], 0.0, 1e-9);
    dem_free(dem);
    particles_free(ps);
}

/* Of Heun's two halves each would take half of a step with its own velocity. */
FACT_FOR_EACH(prescribed_particle_moves_alike_with_every_integrator, 3)
{
    const double A = 0.1, f = 3.0, dt = 1e-3;
    const struct prescribed_particle one = {
        .id = 0, .motion = {.amplitude = {0.0, A, 0.0}, .frequency = f}};
    struct dem_options o = with(NULL, dt);
    struct particles *const ps = sphere_at(0.0, 0.0, 1.0);
    struct dem_report r;

    o.prescribed = &one;
    o.n_prescribed = 1;
    o.integrator = integrators[_i];
    struct dem *const dem = started(ps, &o);
    for (int k = 1; k <= 10; k++) {
        const double phase = 2.0 * M_PI * f * 77.0 * dt * k;
        ck_assert_int_eq(dem_run(dem, 77, &r), 0);
        ck_assert_double_eq_tol(ps->y[0], A * sin(phase), 1e-11);
        ck_assert_double_eq_tol(ps->vy[0], 2.0 * M_PI * f * A * cos(phase),
                                1e-9);
    }
    dem_free(dem);
    particles_free(ps);
}

/* Moved into a plate by delta at V, and released: it has the elastic and the
 * kinetic energy, (1/2) k delta^2 + (1/2) m V^2. A per cent for the way of a
 * last step. */
FACT_FOR_EACH(released_prescribed_particle_keeps_its_energy, 3)
{
    const double V = 0.01, until = 0.1, delta = V * until;
    const struct prescribed_particle one = {
        .id = 0, .motion = {.velocity = {0.0, -V, 0.0}, .until = until}};
    const struct surface s = plate(&(struct motion){.until = 0.0});
    struct dem_options o = with(&s, 1e-4);
    struct particles *const ps = sphere_at(0.0, 0.05, 0.0);
    const double own = ps->m[0] * V * V;
    double fastest = 0.0;
    struct dem_report r;

    o.prescribed = &one;
    o.n_prescribed = 1;
    o.integrator = integrators[_i];
    struct dem *const dem = started(ps, &o);
    for (int k = 0; k < 2000; k++) {
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        fastest = fmax(fastest, fabs(ps->vy[0]));
    }
    const double most = o.material.stiffness * delta * delta + own;
    ck_assert_double_gt(fastest, V);
    ck_assert_double_le(ps->m[0] * fastest * fastest, 1.01 * most);
    dem_free(dem);
    particles_free(ps);
}

/* A run that is cut and goes on with a new dem, its clock set: the state
 * consists of particles, tangential displacements and the time. The springs are
 * turned into the plane of contact once more, which changes their last bits,
 * and bouncing makes more of them. */
FACT(a_prescribed_motion_depends_on_time_alone)
{
    const struct motion m = {.centre = {0.1, 0.0, 0.3},
                             .amplitude = {0.0, 0.01, 0.0},
                             .frequency = 3.0,
                             .spin = {0.0, 3.0, 0.0}};
    struct surface s = sheet(&m);
    const struct dem_options o = with(&s, 1e-4);
    struct particles *ps[2];
    struct dem_report r;
    int n;

    for (int k = 0; k < 2; k++) {
        ps[k] = particles_create(1);
        spheres_add(ps[k], 0.2, 0.063, 0.1, 0.125);
        ps[k]->ey[0] = -g * ps[k]->m[0];
    }
    struct dem *const whole = started(ps[0], &o);
    struct dem *const first = started(ps[1], &o);
    dem_run(whole, 4000, &r);
    dem_run(whole, 4000, &r);
    dem_run(first, 4000, &r);
    struct dem_history *const list = dem_histories(first, &n);
    struct dem *const second = started(ps[1], &o);
    dem_clock(second, 4000);
    dem_restore_histories(second, list, n);
    dem_run(second, 4000, &r);
    ck_assert_double_eq_tol(ps[0]->x[0], ps[1]->x[0], 1e-10);
    ck_assert_double_eq_tol(ps[0]->y[0], ps[1]->y[0], 1e-10);
    ck_assert_double_eq_tol(ps[0]->wz[0], ps[1]->wz[0], 1e-7);
    free(list);
    dem_free(whole);
    dem_free(first);
    dem_free(second);
    particles_free(ps[0]);
    particles_free(ps[1]);
    forget(&s);
}

/* --- a load ----------------------------------------------------------------
 */

enum { COLUMN = 10 };

/* Ten spheres of 0.2 m on the floor of the box, without weight. */
static struct particles *column(void)
{
    struct particles *const ps = particles_create(COLUMN);

    for (int i = 0; i < COLUMN; i++)
        spheres_add(ps, 0.0, -1.9 + 0.2 * i, 0.0, 0.2);
    return ps;
}

/* By how much a load W brings them together [m]: springs in series, the first
 * and the last against a wall. */
static double compression(const struct dem_options *o, double W)
{
    const double E =
        contact_hertz_modulus(o->material.young, 0.25, o->material.young, 0.25);

    if (o->law == &contact_linear)
        return (COLUMN + 1) * W / o->material.stiffness;
    return (COLUMN - 1) * pow(0.75 * W / (E * sqrt(0.05)), 2.0 / 3.0) +
           2.0 * pow(0.75 * W / (E * sqrt(0.1)), 2.0 / 3.0);
}

/* A plate comes down on them from 1 mm above and rests where it exerts its
 * load, of either law, with every integrator, and with much damping: neither
 * above it by more than 1 % on the way, nor beside it at the end. */
FACT_FOR_EACH(a_plate_rests_where_it_exerts_its_load, 12)
{
    const double W = 100.0, top = 0.001;
    struct surface s = plate(&(struct motion){.from = 0.0});
    struct carrier at = {.t = 0.0};
    struct particles *const ps = column();
    struct dem_report r;
    double most = 0.0;

    s.normal[1] = -1.0;
    s.load = (struct motion_load){{0.0, -W, 0.0}, 0.02, &at};
    at.pose = motion_pose(&s.motion, 0.0);
    at.pose.centre[1] = top;
    s.motion.carrier = &at;
    struct dem_options o = with(&s, 5e-5);
    o.law = _i % 2 ? &contact_hertz : &contact_linear;
    o.integrator = integrators[_i / 2 % 3];
    o.material.stiffness = 1e6;
    if (_i >= 6) o.material.restitution = 0.05; /* mostly dashpot */
    struct dem *const dem = dem_create(ps, &o);
    dem_clock(dem, 0);
    for (int k = 0; k < 800; k++) {
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
        most = fmax(most, dem_surface(dem, 0).force[1]);
    }
    ck_assert_double_eq_tol(dem_surface(dem, 0).force[1] / W, 1.0, 1e-7);
    ck_assert_double_eq_tol(
        -dem_surface(dem, 0).pose.centre[1] / compression(&o, W), 1.0, 1e-7);
    ck_assert_double_le(most, 1.01 * W);
    dem_free(dem);
    particles_free(ps);
}
