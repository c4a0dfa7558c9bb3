/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lift of a shear and of a spin, and the torque of the fluid. */
#include "coupling/effects/forces.h"

#include "base/vector.h"
#include "facts.h"
#include "orders.h"

/* --- Saffman ------------------------------------------------------------- */

/* Re_G of a shear of 3 1/s in water, d = 0.1 mm. */
FACT(ls_5_5_reynolds_number_of_a_shear)
{
    ck_assert_double_eq_tol(saffman_reynolds(1e-4, 1e-6, 3.0), 0.03, 1e-16);
}

/* The vector form is the printed one, but for 1.615 and 1.61: a slip along x
 * and u_x that grows with y. */
FACT(ls_5_6_vector_form_is_the_printed_one)
{
    const double rho = 1000.0, mu = 1e-3, d = 1e-4, G = 3.0;
    const double w[3] = {1e-9, 0.0, 0.0}, curl[3] = {0.0, 0.0, -G};
    double F[3];

    saffman_lift(rho, mu, d, w, curl, F);
    ck_assert_double_eq_tol(saffman_reynolds(d, mu / rho, G), 0.03, 1e-15);
    /* Mei's factor at this slip: exp(-Re/10) is 1 to 1e-5, and the rest is the
     * tail 0.3314 sqrt(alpha) (1 - exp(-Re/10)), 4e-4 of it. */
    ck_assert_double_eq_tol(
        F[1] / (1.615 / 1.61 *
                saffman_force(mu, d, w[0], saffman_reynolds(d, mu / rho, G))),
        1.0, 1e-3);
    ck_assert_double_eq(F[0], 0.0);
    ck_assert_double_eq(F[2], 0.0);
}

/* At Re -> 0 the factor is 1; a code that has (1 - 0.3314) sqrt(alpha) misses
 * this by far. At Re = 40 Mei's two branches differ by what the exponential has
 * left there, exp(-4) = 0.018 at most, as 0.0524 sqrt(40) = 0.3314 to 4
 * digits. */
FACT(ls_5_6_meis_factor_starts_at_one_and_is_nearly_continuous)
{
    static const double alpha[] = {0.005, 0.05, 0.4};

    for (int i = 0; i < 3; i++) {
        const double below = saffman_factor(40.0, alpha[i]);
        const double above = saffman_factor(40.0 + 1e-9, alpha[i]);
        ck_assert_double_eq_tol(
            below - above, exp(-4.0) * (1.0 - 0.3314 * sqrt(alpha[i])), 1e-4);
        ck_assert_double_eq_tol(saffman_factor(1e-9, alpha[i]), 1.0, 1e-9);
        ck_assert_double_lt(saffman_factor(100.0, alpha[i]), 0.34);
    }
}

/* One sphere in the middle of a shear u_x = G y with this slip along x, in a
 * fluid that does not feel it. */
static struct simulation *in_shear(const struct scene *s, double G, double slip)
{
    struct simulation *const sim = build(s);
    const struct mesh *const m = sim->mesh;
    const int host = m->n_cells / 2 + s->cells * (s->cells / 2) + s->cells / 2;

    sim->particles->x[0] = m->centre[3 * host];
    sim->particles->y[0] = m->centre[3 * host + 1];
    sim->particles->z[0] = m->centre[3 * host + 2];
    for (int c = 0; c < m->n_cells; c++) {
        sim->fluid->u[3 * c] = G * m->centre[3 * c + 1];
        sim->fluid->u[3 * c + 1] = sim->fluid->u[3 * c + 2] = 0.0;
    }
    averaging_bind(sim->averaging);
    sim->coupling->u_f[0] = sim->fluid->u[3 * host];
    sim->coupling->u_f[1] = sim->coupling->u_f[2] = 0.0;
    sim->particles->vx[0] = sim->coupling->u_f[0] - slip;
    sim->particles->vy[0] = sim->particles->vz[0] = 0.0;
    return sim;
}

static struct scene still(void)
{
    struct scene s = air;

    s.one_way = s.substeps = s.n = 1;
    s.averaging = "pcm";
    s.pressure_gradient = 0;
    s.d = 1e-4;
    return s;
}

/* What one effect does in one sub-step of a step. */
static void act(struct simulation *sim)
{
    const struct effect_state *const e = &sim->effects[sim->n_effects - 1];

    sim->substep = sim->dt;
    e->effect->before_particles(e->memory, sim);
    e->effect->before_substep(e->memory, sim);
}

/* A particle that lags (w > 0) is lifted towards the faster fluid, one that
 * leads towards the slower, in a shear of either sign; the size is the
 * formula's to rounding. */
FACT_FOR_EACH(ls_5_6_who_lags_goes_to_the_faster_side, 4)
{
    const double G = _i % 2 ? 40.0 : -40.0, slip = _i / 2 ? 0.02 : -0.02;
    struct scene s = still();
    s.saffman = 1;
    struct simulation *const sim = in_shear(&s, G, slip);
    const double w[3] = {slip, 0.0, 0.0}, curl[3] = {0.0, 0.0, -G};
    double F[3];

    act(sim);
    saffman_lift(s.rho, s.mu, s.d, w, curl, F);
    ck_assert_double_eq_tol(sim->particles->ey[0], F[1], 1e-12 * fabs(F[1]));
    ck_assert_double_gt(sim->particles->ey[0] * G * slip, 0.0);
    ck_assert_double_eq_tol(sim->particles->ex[0], 0.0, 1e-12 * fabs(F[1]));
    discard(sim);
}

/* u_a = G x_b of any two axes: the curl is along the third, with the sign of
 * their order. */
FACT_FOR_EACH(ls_5_6_a_shear_along_any_axes_has_its_own_curl, 6)
{
    const int a = _i / 2, b = (a + 1 + _i % 2) % 3, axis = 3 - a - b;
    const double G = 40.0, w[3] = {0.02, 0.01, -0.015};
    struct scene s = still();
    s.saffman = 1;
    struct simulation *const sim = in_shear(&s, 0.0, 0.0);
    struct particles *const ps = sim->particles;
    const double at[3] = {ps->x[0], ps->y[0], ps->z[0]};
    double curl[3] = {0.0, 0.0, 0.0}, F[3];

    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->u[3 * c + a] = G * sim->mesh->centre[3 * c + b];
    sim->coupling->u_f[a] = G * at[b];
    ps->vx[0] = sim->coupling->u_f[0] - w[0];
    ps->vy[0] = sim->coupling->u_f[1] - w[1];
    ps->vz[0] = sim->coupling->u_f[2] - w[2];
    act(sim);
    curl[axis] = (b + 1) % 3 == a ? G : -G;
    saffman_lift(s.rho, s.mu, s.d, w, curl, F);
    const double size = 1e-12 * vector_length(F);
    ck_assert_double_eq_tol(ps->ex[0], F[0], size);
    ck_assert_double_eq_tol(ps->ey[0], F[1], size);
    ck_assert_double_eq_tol(ps->ez[0], F[2], size);
    discard(sim);
}

/* With a gradient bandwidth the curl is that of a Gaussian: a wave of wave
 * number k has k exp(-(k b)^2 / 4) of it, where differences of the cells have
 * sin(k h) / h. The kernel ends at 3 b and is a sum over cells. */
FACT_FOR_EACH(ew18_b_6_the_lift_of_a_wave_is_damped_as_the_kernel, 2)
{
    const double slip = 0.02, b = 1.25; /* [m/s], [-] cells */
    struct scene s = still();
    s.saffman = 1;
    s.gradient_width = _i ? b : 0.0;
    struct simulation *const sim = in_shear(&s, 0.0, slip);
    const double h = s.size / s.cells, k = 2.0 * M_PI / s.size;
    double F[3], curl[3] = {0.0, 0.0, 0.0};

    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->u[3 * c] = sin(k * sim->mesh->centre[3 * c + 1]);
    act(sim);
    curl[2] = -cos(k * sim->particles->y[0]) *
              (_i ? k * exp(-0.25 * gsl_pow_2(k * b * h)) : sin(k * h) / h);
    const double w[3] = {slip, 0.0, 0.0};
    saffman_lift(s.rho, s.mu, s.d, w, curl, F);
    ck_assert_double_eq_tol(sim->particles->ey[0] / F[1], 1.0,
                            _i ? 2e-3 : 1e-12);
    discard(sim);
}

/* --- Magnus --------------------------------------------------------------- */

/* (pi/8) rho d^3 w x Omega of Rubinow and Keller where Re is small; LS 5.7 with
 * their coefficient. */
FACT(ls_5_7_slow_spin_is_rubinow_and_keller)
{
    const double rho = 1.2, mu = 1.8e-5, d = 1e-4;
    const double w[3] = {3e-6, -1e-6, 2e-6}, Omega[3] = {1e-3, 2e-3, -1e-3};
    double F[3], cross[3];

    spin_lift(rho, mu, d, w, Omega, F);
    vector_cross(w, Omega, cross);
    for (int k = 0; k < 3; k++) /* exp(-0.057 Re_r^0.4 Re^0.3): 3e-5 */
        ck_assert_double_eq_tol(
            F[k], M_PI / 8.0 * rho * gsl_pow_3(d) * cross[k],
            1e-3 * M_PI / 8.0 * rho * gsl_pow_3(d) * vector_length(cross));
    ck_assert_double_eq_tol(spin_force(rho, 0.5, d, 2.0),
                            0.25 * M_PI * rho * d * d, 1e-20);
    ck_assert(spin_force(rho, 0.5, d, -2.0) == -spin_force(rho, 0.5, d, 2.0));
}

/* Oesterle and Bui Dinh's coefficient tends to 0.45 for fast spins and
 * slips, where Rubinow and Keller's grows without limit. */
FACT(ls_5_7_the_coefficient_of_a_fast_spin_levels_off)
{
    ck_assert_double_eq_tol(spin_lift_coefficient(1e-6, 2e-6), 2.0, 1e-3);
    ck_assert_double_eq_tol(spin_lift_coefficient(140.0, 1400.0), 0.45, 0.15);
}

/* A ball with backspin, on its way along x: spin about z, lift along y. It is
 * the spin against the fluid that counts: a sphere that turns with a shear has
 * none. */
FACT_FOR_EACH(ls_5_7_backspin_lifts_and_the_fluids_own_turn_does_not, 2)
{
    const double G = _i ? 40.0 : 0.0;
    struct scene s = still();
    s.magnus = 1;
    struct simulation *const sim = in_shear(&s, G, -0.5);

    sim->particles->wz[0] = _i ? -0.5 * G : 300.0;
    act(sim);
    if (_i)
        ck_assert_double_eq_tol(sim->particles->ey[0], 0.0, 1e-24);
    else
        ck_assert_double_gt(sim->particles->ey[0], 0.0);
    discard(sim);
}

/* --- the torque ------------------------------------------------------------
 */

/* In slow rotation I domega/dt = -pi mu d^3 Omega. The two branches meet at
 * Re_r = 32 within 0.2 %. */
FACT(torque_is_pi_mu_d_cubed_in_slow_rotation)
{
    const double rho = 1.2, mu = 1.8e-5, d = 1e-3, rho_s = 1000.0;
    const double I = M_PI * rho_s * gsl_pow_5(d) / 60.0;

    ck_assert_double_eq_tol(spin_decay_rate(rho, mu, d, rho_s, 1.0) /
                                (M_PI * mu * gsl_pow_3(d) / I),
                            1.0, 1e-14);
    ck_assert_double_eq_tol(
        spin_torque_factor(32.0 + 1e-9) / spin_torque_factor(32.0), 1.0, 2e-3);
}

/* However long the step, the spin tends to half of the curl and does not swing
 * about it: exp(-r t) to rounding, in one step or in ten. */
FACT_FOR_EACH(torque_takes_the_spin_to_that_of_the_fluid, 2)
{
    const double G = 40.0, omega = 10.0;
    struct scene s = still();
    s.fluid_torque = 1;
    s.dt = _i == 0 ? 1e-4 : 1.0;
    struct simulation *const sim = in_shear(&s, G, 0.0);
    const double rate = spin_decay_rate(s.rho, s.mu, s.d, s.rho_s, 1.0);

    sim->particles->wz[0] = omega;
    for (int n = 0; n < 10; n++)
        act(sim);
    ck_assert_double_eq_tol(
        sim->particles->wz[0],
        -0.5 * G + (omega + 0.5 * G) * exp(-rate * 10.0 * s.dt), 1e-10);
    discard(sim);
}

/* Without viscosity lift and torque are the limit of a small one, and none is
 * not a number: Mei's law at large Re, 0.45 for Magnus's, no torque. */
FACT(ls_5_6_lifts_have_their_limit_without_viscosity)
{
    const double rho = 1.2, d = 1e-3, least = 1e-300;
    const double w[3] = {0.3, -0.1, 0.2}, turn[3] = {10.0, 20.0, -10.0};
    double at_0[3], limit[3];

    saffman_lift(rho, 0.0, d, w, turn, at_0);
    saffman_lift(rho, least, d, w, turn, limit);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(at_0[k] / limit[k], 1.0, 1e-12);
    spin_lift(rho, 0.0, d, w, turn, at_0);
    spin_lift(rho, least, d, w, turn, limit);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(at_0[k] / limit[k], 1.0, 1e-12);
    ck_assert_double_eq(spin_decay_rate(rho, 0.0, d, 1000.0, 5.0), 0.0);
    saffman_lift(rho, 0.0, d, (double[3]){0.0}, turn, at_0);
    ck_assert_double_eq(at_0[0], 0.0);
}

/* --- the path of a spinning ball ------------------------------------------ */

/* How far off it is [m] after T in so many steps. */
static double miss(const struct orders_flight *o, int steps)
{
    double found[ORDERS_Q], exact[ORDERS_Q];

    orders_fly(o, steps, found, exact);
    return hypot(found[ORDERS_X] - exact[ORDERS_X],
                 found[ORDERS_Y] - exact[ORDERS_Y]);
}

/* The course of a ball with drag, Magnus's lift and the decay of its spin
 * against the same equations by Runge and Kutta: order one, as of the drag
 * itself. With 400 steps it is found to a 2000th of what the lift bends it by.
 */
FACT(ls_5_7_a_spinning_ball_flies_a_curve_of_order_one)
{
    struct orders_flight o = orders_flight();
    double bent[ORDERS_Q], exact[ORDERS_Q];
    o.s.rho = air.rho;
    o.s.mu = air.mu;
    o.s.fluid_torque = o.s.magnus = 1;
    o.s.d = 5e-4;
    o.s.rho_s = 100.0;
    o.s.size = 0.1;
    o.U = 0.0;
    o.v[0] = 0.3;
    o.v[1] = 0.1;
    o.omega = 2000.0;
    o.T = 0.02;
    const double coarse = miss(&o, 100), fine = miss(&o, 400);

    ck_assert_double_eq_tol(log2(coarse / fine) / 2.0, 1.0, 0.1);
    orders_fly(&o, 400, bent, exact);
    o.s.magnus = 0;
    orders_fly(&o, 400, exact, (double[ORDERS_Q]){0.0});
    ck_assert_double_lt(fine, 5e-4 * hypot(bent[ORDERS_X] - exact[ORDERS_X],
                                           bent[ORDERS_Y] - exact[ORDERS_Y]));
}
