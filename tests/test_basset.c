/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Basset's history force. */
#include "coupling/effects/forces.h"

#include "facts.h"
#include "orders.h"

/* --- the kernel --------------------------------------------------------- */

static const int terms[] = {15, 25, 37, 51};
static const double tolerances[] = {2e-2, 2e-3, 2e-4, 2e-5};

/* Between one step and a million the sum differs from 1/sqrt(t) by at most the
 * tolerance. If it were less than a half of that, there would be more terms
 * than needed. */
FACT_FOR_EACH(ls_5_4_the_sum_of_exponentials_is_one_over_the_root, 4)
{
    const double dt = 3e-4, tolerance = tolerances[_i];
    const struct basset_kernel k = basset_kernel_create(dt, tolerance);
    double worst = 0.0;

    for (double t = dt; t <= 1e6 * dt; t *= 1.01)
        worst = fmax(worst, fabs(basset_kernel_value(&k, t) * sqrt(t) - 1.0));
    ck_assert_double_le(worst, tolerance);
    ck_assert_double_ge(worst, 0.5 * tolerance);
    ck_assert_int_eq(k.n, terms[_i]);
}

/* Of a slip that grows at a constant rate the force is 3 d^2 sqrt(pi rho mu t)
 * w'. */
FACT(ls_5_4_force_at_a_constant_rate)
{
    ck_assert_double_eq_tol(basset_force(1000.0, 1e-3, 1e-3, 4.0, 0.5),
                            3e-6 * sqrt(M_PI * 4.0) * 0.5, 1e-18);
}

/* --- settling from rest -------------------------------------------------- */

/* v/v_t of a sphere let go at rest, with drag after Stokes, added mass and
 * history; time over T = (2 a^2/9 nu) (ratio + 1/2). Roots of z^2 + B z + 1. */
static double exact(double ratio, double t)
{
    const double B = 3.0 / sqrt(2.0 * ratio + 1.0);
    const double complex root = csqrt(B * B - 4.0);
    const double complex z1 = 0.5 * (-B + root), z2 = 0.5 * (-B - root);

    return creal(1.0 + (z2 * orders_scaled_erfc(-z1 * sqrt(t)) -
                        z1 * orders_scaled_erfc(-z2 * sqrt(t))) /
                           (z1 - z2));
}

/* Water and a Reynolds number of about 1e-9, so that the drag is Stokes' to
 * 1e-7. */
static struct scene creeping(double ratio, double dt)
{
    struct scene s = air;

    s.one_way = s.substeps = s.n = s.dem_steps = 1;
    s.cells = 3;
    s.rho = 1000.0;
    s.mu = 0.1;
    s.rho_s = ratio * s.rho;
    s.d = 1e-4;
    s.drag = "schiller-naumann";
    s.relaxation = SLIP_INTEGRATION_EXPONENTIAL;
    s.virtual_mass = 0.5;
    s.basset = 1e-4;
    s.gravity[1] = -1e-3;
    s.dt = dt * gsl_pow_2(s.d) / 18.0 / (s.mu / s.rho) * (ratio + 0.5);
    return s;
}

static void let_go(struct simulation *sim)
{
    sim->particles->vx[0] = sim->particles->vy[0] = sim->particles->vz[0] = 0.0;
    memset(sim->fluid->u, 0, 3 * (size_t)sim->mesh->n_cells * sizeof(double));
    memset(sim->fluid->phi, 0, (size_t)sim->mesh->n_faces * sizeof(double));
    coupling_start(sim);
}

/* The largest difference to the exact velocity over v_t, to 4 relaxation
 * times. */
static double settle(double ratio, double dt, double basset)
{
    struct scene s = creeping(ratio, dt);
    double worst = 0.0;

    s.basset = basset;
    struct simulation *const sim = build(&s);
    const double v_t =
        (ratio - 1.0) * s.rho * s.gravity[1] * s.d * s.d / (18.0 * s.mu);
    let_go(sim);
    for (int n = 1; n * dt <= 4.0; n++) {
        run(sim, 1);
        const double v = sim->particles->vy[0] / v_t;
        worst = fmax(worst, fabs(v - exact(ratio, n * dt)));
    }
    discard(sim);
    return worst;
}

static const double ratios[] = {0.1, 0.5, 1.2, 2.65, 8.0};

/* With steps of a twentieth and an eightieth of the relaxation time: between
 * order 1.5, of the first step, in which the slip goes with the root of the
 * time, and order 2. Without the force the error is a quarter of the velocity
 * and more. */
FACT_FOR_EACH(ls_5_4_settling_from_rest_is_boussinesq_basset_oseen, 5)
{
    const double coarse = settle(ratios[_i], 0.05, 1e-4);
    const double fine = settle(ratios[_i], 0.0125, 1e-4);
    const double without = settle(ratios[_i], 0.05, 0.0);

    ck_assert_double_le(coarse, 6e-4);
    ck_assert_double_ge(log2(coarse / fine) / 2.0, 1.65);
    ck_assert_double_ge(without, 0.2);
}

/* Half of the space is heavy spheres in gas, which slows down. The largest step
 * by which the mean velocity of the gas goes back again, over its first step
 * after the beginning; 0: the gas only slows down. */
static double ringing(double virtual_mass, double basset)
{
    struct scene s = air;
    double first = 0.0, back = 0.0, past = 0.0;
    s.n = 1728; /* touching, 12 a side */
    s.d = 0.9999e-3;
    s.virtual_mass = virtual_mass;
    s.basset = basset;
    struct simulation *const sim = build(&s);

    for (int i = 0; i < s.n; i++)
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
    for (int step = 0; step < 12; step++) {
        double mean = 0.0;
        run(sim, 1);
        for (int c = 0; c < sim->mesh->n_cells; c++)
            mean += sim->fluid->u[3 * c] / sim->mesh->n_cells;
        if (step == 1) first = past - mean;
        if (step > 1) back = fmax(back, mean - past);
        past = mean;
    }
    discard(sim);
    return back / first;
}

/* A change of the gas pushes the spheres with virtual mass and history. If the
 * reaction came a step later, it would throw the gas back by (C + C_B)
 * eps_s/eps_f = 1.3 of the change, less what the drag takes; of the virtual
 * mass alone, 0.25. The fluid resists both in the same step. */
FACT(ls_5_4_gas_in_a_packed_bed_does_not_ring)
{
    ck_assert_double_lt(ringing(0.9, 2e-2), 0.02);
}

/* Alone the virtual mass would throw it back by 0.36 of the change. */
FACT(ls_5_3_gas_in_a_packed_bed_does_not_ring)
{
    ck_assert_double_lt(ringing(0.9, 0.0), 0.02);
}
