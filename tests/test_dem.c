/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The motion of one and two spheres against closed forms (the verification
 * cases DEM01 to DEM04 of MFiX), and the report of dem_run. */
#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_odeiv2.h>

#include "facts.h"
#include "spheres.h"

static const double g = 9.81; /* [m/s^2] */

static void hang_weight(struct particles *ps)
{
    for (int i = 0; i < ps->n; i++)
        ps->ey[i] = -ps->m[i] * g;
}

/* --- DEM01, DEM02: a sphere falls on a floor -------------------------------
 */

/* d = 0.2 m, 2600 kg/m^3, from 0.5 m above the floor, which is at y = 0. */
enum { FALL_CASES = 4 };
static const double fall_k[FALL_CASES] = {1e4, 2.5e4, 1e5, 1e5};
static const double fall_e[FALL_CASES] = {1.0, 0.8, 1.0, 0.6};
static const double fall_r = 0.1, fall_h = 0.5;

static struct particles *falling_sphere(void)
{
    struct particles *const ps = particles_create(1);

    particles_add(ps, (double[3]){0.0, fall_h, 0.0}, 2.0 * fall_r, 2600.0);
    hang_weight(ps);
    return ps;
}

static struct dem_options fall_options(double k, double e, double step)
{
    struct dem_options o = spheres_options(&contact_linear, step, 1.0);

    o.lo[1] = 0.0;
    o.material.stiffness = k;
    o.material.restitution = e;
    return o;
}

/* Height and speed in the contact, t after it began at speed -v. */
static double pressed(double t, double k, double e, double m, double v,
                      double *speed)
{
    const double eta = contact_linear_damping(k, e, m, 1e30);
    const double b = 0.5 * eta / m, w = sqrt(k / m - b * b), z = m * g / k;
    const double c = (b * z - v) / w;
    const double swing = z * cos(w * t) + c * sin(w * t);

    *speed = exp(-b * t) * (w * (c * cos(w * t) - z * sin(w * t)) - b * swing);
    return fall_r - z + exp(-b * t) * swing;
}

/* Height at time t of the first bounce: fall, contact, rise. The contact ends
 * between one half and, as gravity lengthens it, 1.5 of its gravity-free time.
 */
static double fall_height(double t, double k, double e, double m)
{
    const double t1 = sqrt(2.0 * (fall_h - fall_r) / g), v = g * t1;
    const double t_c = contact_linear_time(k, e, m);
    double low = 0.5 * t_c, high = 1.5 * t_c, speed;

    if (t < t1) return fall_h - 0.5 * g * t * t;
    for (int k2 = 0; k2 < 60; k2++) {
        const double mid = 0.5 * (low + high);
        *(pressed(mid, k, e, m, v, &speed) < fall_r ? &low : &high) = mid;
    }
    if (t - t1 < high) return pressed(t - t1, k, e, m, v, &speed);
    pressed(high, k, e, m, v, &speed);
    t -= t1 + high;
    return fall_r + speed * t - 0.5 * g * t * t;
}

/* 0.1 % of the height; at k = 1e4 the overlap is as large as the radius, but
 * the equation is the same. Damping of the mass m / 2 would miss by 5 %. */
FACT_FOR_EACH(dem01_a_sphere_falls_touches_and_rises_as_the_closed_form,
              FALL_CASES)
{
    const double k = fall_k[_i], e = fall_e[_i];
    struct particles *const ps = falling_sphere();
    const struct dem_options o = fall_options(k, e, 2e-5);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    for (int n = 1; n <= 300; n++) {
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
        ck_assert_double_eq_tol(
            ps->y[0], fall_height(100 * n * o.step, k, e, ps->m[0]), 5e-4);
    }
    ck_assert_double_gt(ps->y[0], 0.15); /* it has left the floor */
    dem_free(dem);
    particles_free(ps);
}

/* Highest point after the second bounce. */
static double second_bounce(double k, double e)
{
    struct particles *const ps = falling_sphere();
    const double t_c = contact_linear_time(k, e, ps->m[0]);
    const struct dem_options o = fall_options(k, e, 2e-3 * t_c);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;
    int tops = 0;
    double v = -1.0;

    while (tops < 2) {
        ck_assert_int_eq(dem_run(dem, 1, &r), 0);
        tops += v > 0.0 && ps->vy[0] <= 0.0;
        v = ps->vy[0];
    }
    const double height = ps->y[0];
    dem_free(dem);
    particles_free(ps);
    return height;
}

/* In the hard limit h_2 - r = (h_0 - r) e^4: gravity acts during a contact that
 * lasts ever shorter. MFiX finds 0.006 to 0.1 % at k = 5e4. */
FACT(dem02_bounces_approach_those_of_a_hard_sphere)
{
    const double e = 0.8, hard = fall_r + (fall_h - fall_r) * pow(e, 4.0);
    const double soft_error = fabs(second_bounce(5e4, e) / hard - 1.0);
    const double stiff_error = fabs(second_bounce(5e6, e) / hard - 1.0);

    ck_assert_double_lt(soft_error, 0.06);
    ck_assert_double_lt(stiff_error, 0.25 * soft_error);
}

/* --- DEM03: two spheres squeezed between floor and ceiling ------------------
 */

static const double squeeze_d = 1e-3, squeeze_top = 1.8e-3, squeeze_k = 1e3;

struct squeeze {
    double e, m[2];
};

/* Springs and dashpots of floor, pair and ceiling; all stay touched. */
static int squeeze_rates(double t, const double y[], double dydt[], void *p)
{
    const struct squeeze *const q = p;
    const double k = squeeze_k, r = 0.5 * squeeze_d;
    const double floor_force =
        k * (r - y[0]) - contact_linear_damping(k, q->e, q->m[0], 1e30) * y[2];
    const double pair =
        k * (squeeze_d - (y[1] - y[0])) -
        contact_linear_damping(k, q->e, q->m[0], q->m[1]) * (y[3] - y[2]);
    const double ceiling =
        k * (y[1] + r - squeeze_top) +
        contact_linear_damping(k, q->e, q->m[1], 1e30) * y[3];

    (void)t;
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = (floor_force - pair) / q->m[0] - g;
    dydt[3] = (pair - ceiling) / q->m[1] - g;
    return GSL_SUCCESS;
}

static struct particles *squeezed_spheres(void)
{
    struct particles *const ps = particles_create(2);

    particles_add(ps, (double[3]){0.0, 4.5e-4, 0.0}, squeeze_d, 2e4);
    particles_add(ps, (double[3]){0.0, 1.35e-3, 0.0}, squeeze_d, 1e4);
    hang_weight(ps);
    return ps;
}

static struct dem_options squeeze_options(double e)
{
    struct dem_options o = spheres_options(&contact_linear, 5e-8, 0.01);

    o.lo[1] = 0.0;
    o.hi[1] = squeeze_top;
    o.material.stiffness = squeeze_k;
    o.material.restitution = e;
    return o;
}

/* Spheres swing by 17 um; 0.1 % of it. A first half kick without the forces of
 * the contacts, which are there from the start, alone makes 0.2 % at e = 1. */
FACT_FOR_EACH(dem03_two_squeezed_spheres_swing_as_the_differential_equation, 2)
{
    const double e = _i == 0 ? 1.0 : 0.5;
    struct particles *const ps = squeezed_spheres();
    struct squeeze q = {e, {ps->m[0], ps->m[1]}};
    const struct dem_options o = squeeze_options(e);
    struct dem *const dem = dem_create(ps, &o);
    gsl_odeiv2_system system = {squeeze_rates, NULL, 4, &q};
    gsl_odeiv2_driver *const driver = gsl_odeiv2_driver_alloc_y_new(
        &system, gsl_odeiv2_step_rk8pd, 1e-7, 1e-14, 1e-10);
    double y[4] = {ps->y[0], ps->y[1], 0.0, 0.0}, t = 0.0;
    struct dem_report r;

    for (int n = 1; n <= 100; n++) {
        ck_assert_int_eq(dem_run(dem, 400, &r), 0);
        gsl_odeiv2_driver_apply(driver, &t, 400 * n * o.step, y);
        ck_assert_double_eq_tol(ps->y[spheres_place(ps, 0)], y[0], 1.7e-8);
        ck_assert_double_eq_tol(ps->y[spheres_place(ps, 1)], y[1], 1.7e-8);
    }
    gsl_odeiv2_driver_free(driver);
    dem_free(dem);
    particles_free(ps);
}

/* Published to 6 and 7 digits. */
FACT(dem03_squeezed_spheres_come_to_rest_where_forces_balance)
{
    struct particles *const ps = squeezed_spheres();
    struct dem_options o = squeeze_options(0.5);
    o.step = 1e-6;
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(dem, 20000, &r), 0);
    ck_assert_double_eq_tol(ps->y[spheres_place(ps, 0)], 4.33248e-4, 1e-9);
    ck_assert_double_eq_tol(ps->y[spheres_place(ps, 1)], 1.366598e-3, 1e-9);
    ck_assert_int_eq(r.contacts, 3);
    dem_free(dem);
    particles_free(ps);
}

/* --- DEM04: a sphere slips until it rolls -----------------------------------
 */

/* The slip v - |w| r falls by (7/2) mu g t, to nothing at t mu g / u0 = 2/7;
 * then u / u0 = w r / u0 = 5/7 for ever. The contact's spring, wound up while
 * it slips, is the error: u may swing by mu^2 g m / k_t of its speed, 1e-5. */
FACT_FOR_EACH(dem04_a_slipping_sphere_rolls_when_friction_has_done_its_work, 5)
{
    const double mu = 0.2 * (_i + 1), u0 = 0.1, r = 5e-4;
    const double t_roll = 2.0 / 7.0 * u0 / (mu * g);
    const int steps = 4000;
    struct particles *const ps = particles_create(1);
    struct dem_options o =
        spheres_options(&contact_linear, t_roll / steps, 0.01);
    struct dem_report report;

    o.material.friction = mu;
    o.material.restitution = 0.3;
    particles_add(ps, (double[3]){0.0, 0.0, 0.0}, 2.0 * r, 1e4);
    ps->y[0] = o.lo[1] + r - ps->m[0] * g / 1e4; /* its weight is borne */
    ps->vx[0] = u0;
    hang_weight(ps);
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, steps * 9 / 10, &report), 0);
    ck_assert_double_eq_tol((ps->vx[0] + ps->wz[0] * r) / u0, 0.1, 1e-3);
    ck_assert_int_eq(dem_run(dem, steps * 6 / 10, &report), 0);
    ck_assert_double_eq_tol(ps->vx[0] / u0, 5.0 / 7.0, 1e-4);
    ck_assert_double_eq_tol(-ps->wz[0] * r / u0, 5.0 / 7.0, 1e-4);
    dem_free(dem);
    particles_free(ps);
}

/* --- a sphere that sticks and swings ----------------------------------------
 */

/* Pressed on the floor and held by the spring k_t, the slip s = v + R omega
 * swings: m dv/dt = F and (2/5) m R^2 domega/dt = R F give (2/7) m s'' = -k_t
 * s. So v = v0 (1 - (2/7) c) and R omega = -(5/7) v0 c with c = 1 - cos(w t),
 * w^2 = 7 k_t/(2 m). The lever is short by half the overlap, 1e-5 R. With I =
 * (2/3) m R^2, a hollow sphere's, half a period later R omega would be off by
 * 0.23 v0. */
FACT(xs11_2_2_a_sticking_sphere_swings_with_two_sevenths_of_its_mass)
{
    const double R = 0.005, k = 1e4, v0 = 1e-4;
    struct particles *const ps = particles_create(1);
    const double m = 2000.0 * 4.0 / 3.0 * M_PI * R * R * R;
    const double w = sqrt(3.5 * (2.0 / 7.0) * k / m), steps = 1000;
    struct dem_options o =
        spheres_options(&contact_linear, 2.0 * M_PI / w / steps, 0.05);
    struct dem_report r;

    o.material.friction = 1.0;
    spheres_add(ps, 0.0, -0.05 + R - 1e-7, 0.0, 2.0 * R);
    ps->ey[0] = -1e-7 * k; /* in balance */
    ps->vx[0] = v0;
    struct dem *const dem = dem_create(ps, &o);
    for (int n = 1; n <= 16; n++) {
        ck_assert_int_eq(dem_run(dem, 125, &r), 0);
        const double c = 1.0 - cos(0.25 * M_PI * n);
        ck_assert_double_eq_tol(ps->vx[0] / v0, 1.0 - 2.0 / 7.0 * c, 1e-4);
        ck_assert_double_eq_tol(R * ps->wz[0] / v0, -5.0 / 7.0 * c, 1e-4);
    }
    dem_free(dem);
    particles_free(ps);
}

/* --- energy ------------------------------------------------------------------
 */

/* Kinetic and elastic energy of the squeezed spheres without gravity. */
static double squeeze_energy(const struct particles *ps)
{
    const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
    const double r = 0.5 * squeeze_d, a = r - ps->y[i];
    const double b = squeeze_d - (ps->y[j] - ps->y[i]);
    const double c = ps->y[j] + r - squeeze_top;

    return 0.5 * (ps->m[i] * ps->vy[i] * ps->vy[i] +
                  ps->m[j] * ps->vy[j] * ps->vy[j] +
                  squeeze_k * (a * a + b * b + c * c));
}

/* Largest error of the energy over `looks` times 50 steps. */
static double energy_error(struct dem *dem, const struct particles *ps,
                           double before, int looks)
{
    struct dem_report r;
    double worst = 0.0;

    for (int k = 0; k < looks; k++) {
        ck_assert_int_eq(dem_run(dem, 50, &r), 0);
        worst = fmax(worst, fabs(squeeze_energy(ps) / before - 1.0));
    }
    return worst;
}

/* Verlet's error swings and stays: after 50 000 steps it is what it was. With
 * the drift by the velocity of the step's start it would grow ten times. */
FACT(energy_of_elastic_spheres_swings_with_dt_squared_and_never_drifts)
{
    double worst[2];

    for (int k = 0; k < 2; k++) {
        struct particles *const ps = squeezed_spheres();
        struct dem_options o = squeeze_options(1.0);
        o.step = k == 0 ? 2e-5 : 1e-5;
        memset(ps->ey, 0, 2 * sizeof *ps->ey);
        const double before = squeeze_energy(ps);
        struct dem *const dem = dem_create(ps, &o);
        worst[k] = energy_error(dem, ps, before, 200);
        energy_error(dem, ps, before, 600);
        const double late = energy_error(dem, ps, before, 200);
        ck_assert_double_eq_tol(late / worst[k], 1.0, 0.02);
        dem_free(dem);
        particles_free(ps);
    }
    ck_assert_double_eq_tol(worst[0] / worst[1], 4.0, 0.2);
}
