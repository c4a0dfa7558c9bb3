/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Single impacts against measured and published ones: the oblique impacts of
 * Kharaz et al. [Kharaz01] and tests 3 to 8 of Chung and Ooi [Chung11]; tests 1
 * and 2 are in test_contact.c. Chapter "Particles, verified". */

#include "facts.h"
#include "impacts.h"

static const double degree = M_PI / 180.0;

/* --- [Chung11] test 3: rebound of a normal impact
 * ------------------------------
 */

/* Tsuji's dashpot gives e exactly where the contact ends at no overlap. Our
 * thousand steps a contact miss by 0.1 % at e = 0.2; without the factor
 * sqrt(5/6) of Hertz's slope e = 0.8 would miss by 2 %. */
FACT_FOR_EACH(chung_ooi_test_3_a_normal_impact_returns_e, 10)
{
    const double e = 0.2 * (1 + _i / 2);
    const struct impact c = {.partner = RIGID_PLANE,
                             .R = 2.5e-3,
                             .density = _i % 2 ? 7000 : 4000,
                             .young = _i % 2 ? 100e9 : 380e9,
                             .poisson = _i % 2 ? 0.25 : 0.23,
                             .e = e,
                             .v_n = 3.9};

    ck_assert_double_eq_tol(impact_run(&c).v_n / (3.9 * e), 1.0, 2e-3);
}

/* --- [Kharaz01], [Chung11] test 4: oblique impacts at 3.9 m/s
 * ---------------------
 */

/* Aluminium oxide on glass. The anvil yields too: a rigid plane under a sphere
 * of the same E* and G* is the same contact. */
static struct impact kharaz(double angle)
{
    const double E = contact_hertz_modulus(380e9, 0.23, 70e9, 0.25);
    const double G = contact_hertz_shear(380e9, 0.23, 70e9, 0.25);
    const double q = G / E, nu = (1.0 - 4.0 * q) / (1.0 - 2.0 * q);

    return (struct impact){.partner = RIGID_PLANE,
                           .R = 2.5e-3,
                           .density = 4000,
                           .young = E * (1.0 - nu * nu),
                           .poisson = nu,
                           .e = 0.98,
                           .mu = 0.092,
                           .v_n = 3.9 * cos(angle * degree),
                           .v_t = 3.9 * sin(angle * degree)};
}

/* angle of the impact [deg], measured: angle of the rebound [deg] */
static const double measured_angle[][2] = {
    {2.2945, 1.763},    {4.2922, 2.9577},   {9.9429, 6.6917},
    {20.5594, 12.3645}, {30.3767, 21.7809}, {39.6233, 32.5455},
    {49.7831, 45.1051}, {60.0571, 57.3652},
};

/* 2 degrees and 0.05 are how far other codes lie from the measurement. Without
 * friction the angle at 20 degrees would be 20.4. */
FACT_FOR_EACH(kharaz_the_sphere_leaves_at_the_measured_angle,
              sizeof measured_angle / sizeof *measured_angle)
{
    const struct impact c = kharaz(measured_angle[_i][0]);
    const struct rebound b = impact_run(&c);
    ck_assert_double_eq_tol(atan2(b.v_t, b.v_n) / degree, measured_angle[_i][1],
                            2.0);
}

/* angle of the impact [deg], measured: tangential restitution [-]; at 2 and 4
 * degrees a part of a degree in the angle is more than the band. */
static const double measured_e_t[][2] = {
    {9.6304, 0.6728},  {20.0845, 0.5964}, {30.2218, 0.6883},
    {39.3031, 0.7719}, {49.5459, 0.8469}, {59.8416, 0.9019},
};

FACT_FOR_EACH(kharaz_the_sphere_keeps_the_measured_part_of_its_speed_along,
              sizeof measured_e_t / sizeof *measured_e_t)
{
    const struct impact c = kharaz(measured_e_t[_i][0]);
    ck_assert_double_eq_tol(impact_run(&c).v_t / c.v_t, measured_e_t[_i][1],
                            0.05);
}

/* angle of the impact [deg], measured: spin [rad/s] */
static const double measured_spin[][2] = {
    {10.984, 264.5493},  {21.1931, 577.0096}, {31.0947, 612.6481},
    {39.0283, 595.4843}, {50.2214, 452.9444}, {60.246, 381.3185},
};

/* 8 % but for 11 degrees, where the curve is steep: there 16 % (chapter
 * "Particles, verified"). */
FACT_FOR_EACH(kharaz_the_sphere_leaves_with_the_measured_spin,
              sizeof measured_spin / sizeof *measured_spin)
{
    const struct impact c = kharaz(measured_spin[_i][0]);
    const double band = _i == 0 ? 0.16 : 0.08;
    ck_assert_double_eq_tol(-impact_run(&c).spin / measured_spin[_i][1], 1.0,
                            band);
}

/* Aluminium oxide on a rigid plane, the curves of [Chung11]: angle of the
 * impact [deg], e_t [-], spin [rad/s]. */
static const double chung_4[][3] = {
    {10.1, 0.687, 212.0},  {14.98, 0.624, 378.0}, {20.0, 0.616, 511.0},
    {24.98, 0.634, 599.5}, {30.0, 0.683, 616.5},  {39.98, 0.781, 544.8},
    {50.0, 0.845, 457.0},  {60.0, 0.893, 357.5},  {80.0, 0.966, 126.3},
};

/* The curves were read from a print, to about 0.01 and 5 rad/s. */
FACT_FOR_EACH(chung_ooi_test_4_oblique_impacts_lie_on_the_published_curves,
              sizeof chung_4 / sizeof *chung_4)
{
    const double a = chung_4[_i][0] * degree;
    const struct impact c = {.partner = RIGID_PLANE,
                             .R = 2.5e-3,
                             .density = 4000,
                             .young = 380e9,
                             .poisson = 0.23,
                             .e = 0.98,
                             .mu = 0.092,
                             .v_n = 3.9 * cos(a),
                             .v_t = 3.9 * sin(a)};
    const struct rebound b = impact_run(&c);
    ck_assert_double_eq_tol(b.v_t / c.v_t, chung_4[_i][1], 0.012);
    ck_assert_double_eq_tol(-b.spin, chung_4[_i][2], 10.0);
}

/* --- [Chung11] test 5: which angle, which spin
 * ---------------------------------
 */

static struct impact steel(double slip)
{
    return (struct impact){.partner = RIGID_PLANE,
                           .R = 1e-5,
                           .density = 7850,
                           .young = 208e9,
                           .poisson = 0.3,
                           .e = 1.0,
                           .mu = 0.3,
                           .v_n = 5.0,
                           .v_t = slip * 0.3 * 5.0};
}

/* v_t/(mu v_n), and R omega/(mu v_n) from finite elements (Wu, in [Chung11]).
 */
static const double wu[][2] = {
    {0.31792, -0.18657}, {0.89017, -0.66529}, {1.5318, -1.3551},
    {2.2775, -2.3208},   {3.3006, -3.4407},   {4.6879, -4.5685},
    {5.659, -4.9415},    {9.0405, -4.9721},   {18.803, -4.9749},
};

/* A contact with one spring sticks or slides as a whole; in the elastic bodies
 * a ring of it slides at any angle. So at small angles there is less spin, by
 * up to 0.55; the published particle code has up to 0.8 too much. */
FACT_FOR_EACH(chung_ooi_test_5_spin_is_near_that_of_finite_elements,
              sizeof wu / sizeof *wu)
{
    const struct impact c = steel(wu[_i][0]);
    ck_assert_double_eq_tol(c.R * impact_run(&c).spin / 1.5, wu[_i][1], 0.6);
}

/* In full sliding J_t = mu m (1 + e) v_n and R omega = -(5/2) J_t/m, up to the
 * end of the contact, where it may stick: 0.3 %. */
FACT_FOR_EACH(chung_ooi_test_5_beyond_the_sliding_angle_spin_is_5_mu_v, 2)
{
    const struct impact c = steel(_i == 0 ? 8.0 : 20.0);
    ck_assert_double_eq_tol(c.R * impact_run(&c).spin / 1.5, -5.0, 0.015);
}

/* --- [Chung11] tests 6 to 8: a spinning sphere
 * ---------------------------------
 */

/* Falls without a speed along the surface; theta = (7/2) mu (1 + e) v_n/(R
 * omega): all slides where theta < 1. */
static struct impact spinning(enum impact_partner partner, int nylon,
                              double theta)
{
    return (struct impact){.partner = partner,
                           .R = 0.1,
                           .density = nylon ? 1000 : 2700,
                           .young = nylon ? 2.5e9 : 70e9,
                           .poisson = nylon ? 0.4 : 0.33,
                           .e = 0.5,
                           .mu = 0.4,
                           .v_n = 0.2,
                           .spin = 3.5 * 0.4 * 1.5 * 0.2 / theta / 0.1};
}

/* Speed of the surface of the sphere after, over before, and turned round. */
static double surface_speed(const struct impact *c)
{
    const struct rebound b = impact_run(c);
    return -(b.v_t + c->R * b.spin) / (c->R * c->spin);
}

/* theta [-], beta [-] of the published curve */
static const double chung_6[][2] = {
    {0.18717, -0.81522}, {0.35829, -0.62625},  {0.5508, -0.43937},
    {0.76471, -0.2378},  {0.97861, -0.017323}, {1.2139, 0.096063},
    {1.492, 0.11076},    {1.7701, 0.089764},   {2.0909, 0.058268},
    {2.5187, 0.0057743},
};

/* 0.06 is the largest difference, where sliding ends. Beyond theta = 2.5 the
 * answer is the tangential dashpot's, and codes have different ones. */
FACT_FOR_EACH(chung_ooi_test_6_slip_of_a_spinning_sphere_is_stopped_by_friction,
              sizeof chung_6 / sizeof *chung_6)
{
    const struct impact c = spinning(RIGID_PLANE, 0, chung_6[_i][0]);
    ck_assert_double_eq_tol(surface_speed(&c), chung_6[_i][1], 0.06);
}

/* Two spheres with equal spins act as planes on each other; so does a sphere
 * that is 125 000 times as heavy. The planes of [Chung11] are rigid and its
 * spheres are elastic, which makes no difference to the friction in full
 * sliding. */
FACT_FOR_EACH(chung_ooi_tests_7_and_8_repeat_test_6, 6)
{
    static const double theta[] = {0.2, 0.6, 0.9};
    const int nylon = _i % 2;
    const struct impact plane = spinning(RIGID_PLANE, nylon, theta[_i / 2]);
    const struct impact pair = spinning(EQUAL_SPHERE, nylon, theta[_i / 2]);
    const struct impact big = spinning(BIG_SPHERE, nylon, theta[_i / 2]);
    const double beta = surface_speed(&plane);

    ck_assert_double_eq_tol(surface_speed(&pair), beta, 5e-4);
    ck_assert_double_eq_tol(surface_speed(&big), beta, 5e-4);
}
