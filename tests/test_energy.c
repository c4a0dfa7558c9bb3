/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The energy budget: it closes to the order of the integrator, and each of its
 * terms is right where one of them acts alone. */
#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdlib.h>

#include "dem/attraction.h"
#include "dem/energy.h"
#include "dem/fast/fast.h"
#include "dem/integrator.h"
#include "dem/contact.h"
#include "dem/reference.h"
#include "dem/surfaces/surface.h"
#include "dem/surfaces/prescribed_particles.h"
#include "facts.h"
#include "spheres.h"

/* Scenes of 64 spheres of several sizes, thrown about in a box under gravity,
 * each with what the one before lacks. */
enum {
    ELASTIC,
    DASHPOTS,
    SLIDING,
    STICKING,
    ATTRACTED,
    ROLLING,
    MOVING_SURFACE,
    SCENES
};

static const struct attraction sticky = {
    .law = &van_der_waals, .range = 0.001, .strength = 1e-8, .closest = 1e-5};
static const struct surface plate = {.name = "ram",
                                     .shape = &surface_plane,
                                     .point = {-0.04, 0.0, 0.0},
                                     .normal = {0.8, 0.6, 0.0},
                                     .motion = {.velocity = {1.0, 0.5, 0.7}}};

static struct dem_options options_of(int scene, const struct contact_law *law)
{
    struct dem_options o = spheres_options(law, 1.0, 0.03);
    const int damps = scene == DASHPOTS || scene >= ATTRACTED;

    o.material.friction = scene == STICKING  ? 2.0
                          : scene >= SLIDING ? 0.3
                                             : 0.0;
    o.material.restitution = damps ? 0.7 : 1.0;
    o.material.rolling = scene >= ROLLING ? 0.1 : 0.0;
    o.attractions = &sticky;
    o.n_attractions = scene == ATTRACTED;
    o.surfaces = &plate;
    o.n_surfaces = scene == MOVING_SURFACE;
    return o;
}

/* The residual over the energy that was turned over: what came in and what
 * became heat. The step is a part of the suggested one. */
static double share_left(int scene, struct dem_options *o, double part)
{
    struct particles *const ps = spheres_cloud(4, 0.008, 0.5, 0.0125, 1.0, 8);
    double least = HUGE_VAL;
    struct dem_report r;

    for (int i = 0; i < ps->n; i++) {
        least = fmin(least, ps->d[i]);
        ps->ey[i] = -10.0 * ps->m[i];
    }
    o->step = part * limits_step(o->law, &o->material, least, 2000.0, 2.0);
    struct dem *const dem = dem_create(ps, o);
    dem_start_energy_budget(dem);
    dem_clock(dem, 0);
    for (int k = 0; k < 20; k++) /* in pieces, as a fluid wants them */
        ck_assert_int_eq(dem_run(dem, (int)lround(0.001 / o->step), &r), 0);
    const struct energy e = *dem_energy(dem);
    const double heat = e.damped_n + e.damped_t + e.slid + e.rolled;
    if (o->material.restitution < 1.0)
        ck_assert_double_gt(e.damped_n, 0.1 * e.added);
    if (scene == SLIDING) ck_assert_double_gt(e.slid, 0.1 * e.added);
    if (scene == MOVING_SURFACE) ck_assert_double_gt(e.walls, e.added);
    dem_free(dem);
    particles_free(ps);
    return energy_residual(&e) /
           (e.added + fabs(e.work) + fabs(e.walls) + fabs(e.attracted) + heat);
}

/* With all laws, integrators and lists the account is right to 5e-4 at the step
 * that `winnow check` suggests, and of second order: half of the step leaves
 * a quarter, or less where the errors of single contacts, which depend on where
 * in a step they begin, leave no more than 5e-6. What Heun's method itself adds
 * to the motion where nothing damps it is of third order, 3e-3 at that step. */
FACT_FOR_EACH(the_energy_budget_closes_to_second_order_with_all_that_acts,
              SCENES * 3 * 3 * 2)
{
    static const struct dem_method *const list[] = {
        &fast_verlet, &reference_link_cells, &reference_all_pairs};
    const int scene = _i % SCENES, method = _i / SCENES % 3;
    const struct integrator *const by = integrators[_i / SCENES / 3 % 3];
    const struct contact_law *const law = contact_laws[_i / SCENES / 9];
    struct dem_options o = options_of(scene, law);

    if (method > 0 && (by->predicts || scene == MOVING_SURFACE)) return;
    o.method = list[method];
    o.integrator = by;
    const int gains = by->predicts && o.material.restitution == 1.0;
    const double half = share_left(scene, &o, 0.5);
    const double quarter = share_left(scene, &o, 0.25);
    ck_assert_double_lt(fabs(share_left(scene, &o, 1.0)), gains ? 3e-3 : 5e-4);
    ck_assert_double_lt(fabs(quarter), 0.35 * fabs(half) + 5e-6);
}

/* A spring that becomes harder, F = k delta (1 + (delta/a)^2): its energy is
 * half of F delta for a small overlap and a quarter of it for a large one. */
static const double hardens_at = 1e-4; /* [m] a; the overlaps reach 3e-4 m */

static struct contact_response
stiffening_respond(const struct contact_constants *k, double delta,
                   double R_star, double m_star)
{
    const double x2 = gsl_pow_2(delta / hardens_at);
    struct contact_response r =
        contact_linear_respond(k, delta, R_star, m_star);

    r.elastic *= 1.0 + x2;
    r.stored *= 1.0 + 0.5 * x2;
    return r;
}

/* All laws of the program, and the one above. */
enum { LAWS = 3 };

static struct contact_law law_number(int i)
{
    struct contact_law law = i < 2 ? *contact_laws[i] : contact_linear;

    if (i == 2) law.respond = stiffening_respond;
    return law;
}

/* Two spheres that are pushed together, once; the largest residual on the way.
 * Nothing damps: second order. */
static double worst_residual(const struct contact_law *law,
                             const struct dem_method *method, double step)
{
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(law, step, 0.1);
    struct dem_report r;
    double worst = 0.0;

    o.method = method;
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    spheres_throw(ps, spheres_add(ps, -0.0051, 0, 0, 0.01), 1.0, 0, 0);
    spheres_throw(ps, spheres_add(ps, 0.0051, 0, 0, 0.01), -1.0, 0, 0);
    for (int k = 0; k * step < 2e-3; k++) {
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        const struct energy *const e = dem_energy(dem);
        worst = fmax(worst, fabs(energy_residual(e)) / e->added);
    }
    const double left = dem_energy(dem)->kinetic / dem_energy(dem)->added;
    ck_assert_double_eq_tol(left, 1.0, 1e-3);
    dem_free(dem);
    particles_free(ps);
    return worst;
}

/* Simpson's rule with 1000 intervals; its error for delta^(3/2), whose second
 * derivative has no bound at 0, is 1e-7. */
FACT_FOR_EACH(a_law_stores_the_integral_of_its_elastic_force, LAWS)
{
    const struct dem_options o = spheres_options(NULL, 1.0, 1.0);
    const struct contact_law law = law_number(_i);
    const struct material_pair pair = materials_mixed(&o.material, &o.material);
    const struct contact_constants k = law.constants(&pair);
    const double deepest = 2e-4, h = deepest / 1000;
    double sum = 0.0;

    for (int i = 0; i <= 1000; i++) {
        const double weight = i == 0 || i == 1000 ? 1.0 : i % 2 ? 4.0 : 2.0;
        sum += weight * h / 3.0 * law.respond(&k, i * h, 0.0025, 1e-3).elastic;
    }
    const double stored = law.respond(&k, deepest, 0.0025, 1e-3).stored;
    ck_assert_double_eq_tol(stored / sum, 1.0, 1e-6);
}

FACT_FOR_EACH(the_energy_budget_closes_to_second_order_where_nothing_damps,
              2 * LAWS)
{
    const struct contact_law law = law_number(_i % LAWS);
    const struct dem_method *const method =
        _i < LAWS ? NULL : &reference_all_pairs;
    const double coarse = worst_residual(&law, method, 8e-6);
    const double fine = worst_residual(&law, method, 2e-6);

    ck_assert_double_lt(fine, 1e-3);
    ck_assert_double_gt(coarse / fine, 12.0); /* 16, up to where it touches */
    ck_assert_double_lt(coarse / fine, 20.0);
}

/* --- one term at a time --------------------------------------------------- */

/* One sphere of 1 cm at the floor of a high box, with a gravity of g. */
struct lone {
    struct particles *ps;
    struct dem *dem;
    double m;
};

static struct lone lone(double e, double mu, double rolling, double height,
                        double g)
{
    struct lone one = {.ps = particles_create(2)};
    struct dem_options o = spheres_options(&contact_linear, 2e-6, 1.0);

    o.material.restitution = e;
    o.material.friction = mu;
    o.material.rolling = rolling;
    one.dem = dem_create(one.ps, &o);
    dem_start_energy_budget(one.dem);
    spheres_add(one.ps, 0, -1.0 + 0.005 + height, 0, 0.01);
    one.m = one.ps->m[0];
    one.ps->ey[0] = -g * one.m;
    return one;
}

static struct energy after(const struct lone *one, double time)
{
    struct dem_report r;

    ck_assert_int_eq(dem_run(one->dem, (int)lround(time / 2e-6), &r), 0);
    return *dem_energy(one->dem);
}

static void done(const struct lone *one)
{
    dem_free(one->dem);
    particles_free(one->ps);
}

/* One bounce at 0.8: of (1/2) m v^2 the normal dashpot takes 1 - e^2. A tenth
 * of a step's error in 200 a contact. */
FACT(the_normal_dashpot_takes_1_less_e_squared)
{
    const struct lone one = lone(0.8, 0.0, 0.0, 0.001, 0.0);

    one.ps->vy[0] = -1.0;
    const struct energy e = after(&one, 0.004);
    ck_assert_double_gt(one.ps->vy[0], 0.0);
    ck_assert_double_eq_tol(e.damped_n / (0.5 * one.m), 1.0 - 0.64, 0.006);
    ck_assert_double_eq_tol(e.normal, 0.0, 1e-15 * one.m);
    done(&one);
}

/* The work of gravity is m g h, to rounding, on the way down. */
FACT(the_work_of_gravity_is_the_height_lost)
{
    const struct lone one = lone(1.0, 0.0, 0.0, 0.5, 9.81);
    const struct energy e = after(&one, 0.1);
    const double fallen = 0.5 * 9.81 * 0.1 * 0.1;

    ck_assert_double_eq_tol(e.work / (one.m * 9.81 * fallen), 1.0, 1e-12);
    ck_assert_double_eq_tol(e.kinetic / e.work, 1.0, 1e-12);
    ck_assert_double_eq_tol(e.added, 0.0, 1e-18);
    done(&one);
}

/* A sphere that is thrown along the floor rolls in the end, at 5/7 of its
 * speed; sliding takes 2/7 of its energy, whatever the friction. It floats at
 * rest on its spring when it begins: the overlap is m g / k. */
FACT(sliding_takes_two_sevenths_until_it_rolls)
{
    struct lone one = lone(0.5, 0.3, 0.0, 0.0, 10.0);

    one.ps->y[0] -= one.m * 10.0 / 1e4;
    one.ps->vx[0] = 0.5;
    const struct energy e = after(&one, 0.1);
    const double whole = 0.5 * one.m * 0.25;
    ck_assert_double_eq_tol(one.ps->vx[0], 0.5 * 5.0 / 7.0, 1e-3);
    ck_assert_double_eq_tol(e.slid / whole, 2.0 / 7.0, 0.003);
    ck_assert_double_lt(fabs(energy_residual(&e)), 1e-3 * whole);
    ck_assert_double_lt(fabs(e.damped_t) + fabs(e.released), 2e-3 * whole);
    done(&one);
}

/* A sphere that rolls is stopped by rolling friction, which takes all of
 * (7/10) m v^2. */
FACT(rolling_friction_takes_what_a_rolling_sphere_has)
{
    struct lone one = lone(0.5, 0.8, 0.1, 0.0, 10.0);

    one.ps->y[0] -= one.m * 10.0 / 1e4;
    one.ps->vx[0] = 0.1;
    one.ps->wz[0] = -0.1 / 0.005;
    const struct energy e = after(&one, 0.25);
    const double whole = 0.7 * one.m * 0.01;
    ck_assert_double_lt(e.kinetic, 1e-4 * whole);
    ck_assert_double_eq_tol(e.rolled / whole, 1.0, 0.03);
    ck_assert_double_lt(fabs(energy_residual(&e)), 0.01 * whole);
    done(&one);
}

/* A sphere hit by a plane that moves at 0.2 m/s leaves at 0.4 m/s: the work of
 * the plane is (1/2) m v^2, the whole energy at the end. */
FACT(a_wall_that_moves_does_the_work_that_it_gives)
{
    struct particles *const ps = particles_create(1);
    struct dem_options o = spheres_options(&contact_linear, 2e-6, 0.1);
    const struct surface piston = {.name = "piston",
                                   .shape = &surface_plane,
                                   .point = {-0.01, 0.0, 0.0},
                                   .normal = {1.0, 0.0, 0.0},
                                   .motion = {.velocity = {0.2, 0.0, 0.0}}};
    struct dem_report r;

    o.surfaces = &piston;
    o.n_surfaces = 1;
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    dem_clock(dem, 0);
    spheres_add(ps, 0.0, 0, 0, 0.01);
    ck_assert_int_eq(dem_run(dem, 20000, &r), 0);
    const struct energy *const e = dem_energy(dem);
    const double whole = 0.5 * ps->m[0] * 0.16;
    ck_assert_double_eq_tol(ps->vx[0], 0.4, 1e-3);
    ck_assert_double_eq_tol(e->walls / whole, 1.0, 2e-3);
    ck_assert_double_lt(fabs(energy_residual(e)), 2e-3 * whole);
    dem_free(dem);
    particles_free(ps);
}

/* The same with a sphere of prescribed motion, from rest: the prescribed motion
 * also gives this sphere its kinetic energy, which it keeps when it is
 * released. Off the line of centres, with friction and a dashpot, the budget
 * still closes. */
FACT_FOR_EACH(a_prescribed_sphere_does_the_work_that_it_gives, 4)
{
    const int rough = _i % 2, stops = _i / 2;
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(&contact_linear, 2e-6, 0.1);
    const struct prescribed_particle ram = {
        .id = 0,
        .motion = {.velocity = {0.2, 0.0, 0.0}, .until = stops ? 0.03 : 0.0}};
    struct dem_report r;

    o.prescribed = &ram;
    o.n_prescribed = 1;
    o.material.friction = rough ? 0.3 : 0.0;
    o.material.restitution = rough ? 0.8 : 1.0;
    spheres_add(ps, -0.012, 0.0, 0.0, 0.01);
    spheres_add(ps, 0.0, rough ? 0.003 : 0.0, 0.0, 0.01);
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    dem_clock(dem, 0);
    for (int k = 0; k < 20; k++)
        ck_assert_int_eq(dem_run(dem, 1000, &r), 0);
    const struct energy *const e = dem_energy(dem);
    const double v = ps->vx[spheres_place(ps, 1)], own = 0.02 * ps->m[0];
    ck_assert_double_gt(v, 0.25);
    ck_assert_double_lt(fabs(energy_residual(e)), 2e-3 * own);
    ck_assert_double_lt(fabs(e->added), 1e-9 * own);
    if (!rough) ck_assert_double_eq_tol(e->walls / own, 5.0, 1e-2);
    dem_free(dem);
    particles_free(ps);
}

/* A sphere that is pushed with V against a wall, a plate, or a sphere that
 * stays in its place by prescription: its dashpot is that of a free sphere of
 * its mass there, which takes eta V^2 a second, eta = 2 zeta sqrt(k m*). Made
 * for the mass of what nothing moves it took a million times as much. The
 * tolerance is the part of the first and the last step. */
FACT_FOR_EACH(dashpots_of_prescribed_spheres_know_their_own_mass, 3)
{
    const double V = 0.01, span = 0.1;
    const struct prescribed_particle two[] = {
        {.id = 0, .motion = {.velocity = {-V, 0.0, 0.0}}},
        {.id = 1, .motion = {.velocity = {0.0, 1e-12, 0.0}}}};
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(&contact_linear, 2e-5, 0.1);
    const struct surface wall = {.name = "plate",
                                 .shape = &surface_plane,
                                 .point = {-0.006, 0.0, 0.0},
                                 .normal = {1.0, 0.0, 0.0}};
    const double m_star[] = {1.0, 1.0, 0.5};
    struct dem_report r;

    o.prescribed = two;
    o.n_prescribed = 2;
    o.material.restitution = 0.5;
    o.surfaces = &wall;
    o.n_surfaces = _i == 1;
    spheres_add(ps, _i == 0 ? -0.095 : _i == 1 ? -0.001 : 0.01, 0.0, 0.0, 0.01);
    spheres_add(ps, _i == 2 ? 0.0 : 0.05, 0.0, 0.0, 0.01);
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    dem_clock(dem, 0);
    ck_assert_int_eq(dem_run(dem, (int)lrint(span / o.step), &r), 0);
    const double eta =
        contact_linear_dashpot(contact_damping_ratio(0.5), o.material.stiffness,
                               m_star[_i] * ps->m[0]);
    const double damped = dem_energy(dem)->damped_n;
    ck_assert_double_eq_tol(damped / (eta * V * V * span), 1.0, 0.01);
    dem_free(dem);
    particles_free(ps);
}

/* Two unlike charges fall towards each other: their kinetic energy is the work
 * of Coulomb's force, q^2/(4 pi eps_0) (1/l - 1/l_0). */
FACT(attractions_do_the_work_that_comes_out_as_motion)
{
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(&contact_linear, 2e-6, 0.1);
    const double charge[2] = {2e-8, -2e-8};
    const struct attraction pull = {.law = &electrostatic,
                                    .range = 0.05,
                                    .strength = 1.0,
                                    .charge = charge};
    const struct material other = o.material;
    const struct materials two = {.n = 2, .further = &other};
    struct dem_report r;

    o.attractions = &pull;
    o.n_attractions = 1;
    o.materials = &two;
    particles_add_material(ps);
    spheres_add(ps, -0.015, 0, 0, 0.01);
    ps->material[spheres_add(ps, 0.015, 0, 0, 0.01)] = 1;
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    ck_assert_int_eq(dem_run(dem, 30000, &r), 0);
    const struct energy *const e = dem_energy(dem);
    const double l = fabs(ps->x[1] - ps->x[0]);
    const double exact = 8.9875518e9 * 4e-16 * (1.0 / l - 1.0 / 0.03);
    ck_assert_double_lt(l, 0.029);
    ck_assert_double_gt(l, 0.0101);
    ck_assert_double_eq_tol(e->attracted / exact, 1.0, 1e-3);
    ck_assert_double_eq_tol(e->kinetic / exact, 1.0, 1e-3);
    dem_free(dem);
    particles_free(ps);
}

/* --- around runs ---------------------------------------------------------- */

FACT(energy_added_between_runs_is_counted)
{
    struct lone one = lone(1.0, 0.0, 0.0, 0.5, 0.0);

    one.ps->vx[0] = 1.0;
    const struct energy first = after(&one, 1e-4);
    ck_assert_double_eq_tol(first.added / (0.5 * one.m), 1.0, 1e-12);
    one.ps->vx[0] = 2.0;
    const int i = spheres_add(one.ps, 0.1, 0.1, 0.1, 0.01);
    one.ps->vz[i] = 3.0;
    dem_changed(one.dem);
    const struct energy e = after(&one, 1e-4);
    ck_assert_double_eq_tol(e.added / (0.5 * one.m), 13.0, 1e-11);
    ck_assert_double_eq_tol(energy_residual(&e) / one.m, 0.0, 1e-13);
    done(&one);
}

/* In pieces, with any number of threads, or not at all: the motion has the
 * same bits, and the budget, too, in one run as in pieces to rounding. */
static struct particles *moved(const struct contact_law *law, int keep,
                               int pieces, struct energy *e)
{
    struct particles *const ps = spheres_cloud(14, 0.004, 0.5, 0.0062, 1.0, 8);
    struct dem_options o = spheres_options(law, 5e-6, 0.0435);
    struct dem_report r;

    o.material.friction = 0.3;
    o.material.restitution = 0.8;
    o.periodic[2] = 1;
    struct dem *const dem = dem_create(ps, &o);
    if (keep) dem_start_energy_budget(dem);
    for (int k = 0; k < pieces; k++)
        ck_assert_int_eq(dem_run(dem, 240 / pieces, &r), 0);
    ck_assert_int_gt(r.contacts, 50);
    if (keep)
        *e = *dem_energy(dem);
    else
        ck_assert_ptr_null(dem_energy(dem));
    dem_free(dem);
    return ps;
}

FACT_FOR_EACH(a_budget_changes_no_bit_and_does_not_depend_on_threads, 2)
{
    const struct contact_law *const law = contact_laws[_i];
    struct energy one, three, pieces;

    omp_set_num_threads(1);
    struct particles *const plain = moved(law, 0, 1, NULL);
    struct particles *const a = moved(law, 1, 1, &one);
    omp_set_num_threads(2);
    struct particles *const b = moved(law, 1, 1, &three);
    struct particles *const c = moved(law, 1, 6, &pieces);
    const size_t size = (size_t)plain->n * sizeof(double);
    ck_assert_mem_eq(plain->x, a->x, size);
    ck_assert_mem_eq(plain->wz, a->wz, size);
    ck_assert_mem_eq(a->vy, b->vy, size);
    ck_assert_mem_eq(&one, &three, sizeof one);
    ck_assert_double_eq_tol(pieces.slid / one.slid, 1.0, 1e-9);
    particles_free(plain);
    particles_free(a);
    particles_free(b);
    particles_free(c);
}
