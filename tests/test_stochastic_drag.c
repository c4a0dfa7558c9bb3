/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "coupling/effects/forces.h"

#include "base/statistics.h"
#include "coupling/effect.h"
#include "facts.h"
#include "suspension.h"

#include <omp.h>

/* --- the signal ----------------------------------------------------------- */

/* Mean over n steps of C'(t) C'(t + lag), of one signal from C' = 0 at -20 T.
 */
static double correlation(double dt, double T, double sigma, int n, int lag)
{
    const double a = stochastic_drag_memory(dt, T);
    double *const past = alloc_doubles(lag + 1), C = 0.0, sum = 0.0;
    const int before = (int)(20.0 * T / dt) + lag;

    for (int k = 0; k < n + before; k++) {
        C = stochastic_drag_step(a, sigma, C, random_normal(7, 3, k, 0));
        past[k % (lag + 1)] = C;
        if (k >= before) sum += C * past[(k + 1) % (lag + 1)];
    }
    free(past);
    return sum / n;
}

/* Variance sigma^2 and R(tau) = exp(-tau / T), whatever the step. The bands are
 * three standard errors of the correlated sample: for the variance sigma^2
 * sqrt(2 T / (n dt)), and no more for the correlation. Without the sqrt(1 -
 * a^2) the variance would be 1/(1 - a^2), 170 times as large at dt = 0.003. */
FACT_FOR_EACH(ew18_33_signal_has_its_variance_and_memory_at_any_step, 3)
{
    static const double step[] = {0.003, 0.03, 0.3};
    const double dt = step[_i], T = 1.0, sigma = 2.0;
    const int n = _i == 0 ? 300000 : 100000;
    const double error = 4.0 * sqrt(2.0 * T / (n * dt));
    const int lag = (int)ceil(0.6 / dt - 1e-9);

    ck_assert_double_eq_tol(correlation(dt, T, sigma, n, 0), 4.0, 3.0 * error);
    ck_assert_double_eq_tol(correlation(dt, T, sigma, n, lag),
                            4.0 * exp(-lag * dt / T), 3.0 * error);
}

/* Paths that begin at C' = 3: their mean and variance after n steps, to three
 * standard errors. The exponent n dt that is printed would give a^0.3 for a^10,
 * a mean of 2.87 for 0.67. */
static void expect(double *mean, double *variance, double a, double b, int n)
{
    enum { PATHS = 20000 };
    double sum = 0.0, square = 0.0;

    for (int i = 0; i < PATHS; i++) {
        double C = 3.0;
        for (int k = 0; k < n; k++)
            C = stochastic_drag_step(a, b, C, random_normal(5, i, k, 0));
        sum += C;
        square += C * C;
    }
    *mean = sum / PATHS;
    *variance = square / PATHS - *mean * *mean;
}

FACT(ew18_35_mean_to_expect_falls_with_the_nth_power_of_a)
{
    const double a = 0.86, b = 2.0;
    double mean, variance;

    expect(&mean, &variance, a, b, 10);
    ck_assert_double_eq_tol(mean, stochastic_drag_mean(a, 10, 3.0),
                            3.0 * sqrt(variance / 20000.0));
    ck_assert_double_eq_tol(stochastic_drag_mean(a, 10, 3.0), 0.6639, 1e-4);
}

FACT(ew18_36_variance_to_expect_grows_to_that_of_the_signal)
{
    const double a = 0.86, b = 2.0;
    double mean, variance;

    expect(&mean, &variance, a, b, 3);
    const double V = stochastic_drag_variance(a, b, 3);
    ck_assert_double_eq_tol(variance, V, 3.0 * V * sqrt(2.0 / 20000.0));
    ck_assert_double_eq_tol(stochastic_drag_variance(a, b, 1000), 4.0, 1e-12);
    ck_assert_double_eq(stochastic_drag_variance(a, b, 0), 0.0);
}

FACT(ew18_37_time_and_memory_are_one_another)
{
    ck_assert_double_eq_tol(
        stochastic_drag_time(stochastic_drag_memory(0.03, 1.7), 0.03), 1.7,
        1e-12);
}

/* EW18's coefficients for the liquid, 512.875 Re^-1.54919, by its ends, and
 * those for the gas, linear. */
FACT(ew18_fig_10_sigma_is_a_power_or_a_line_between_its_ends)
{
    const struct stochastic_drag_sigma liquid = {512.875 * pow(3.0, -1.54919),
                                                 512.875 * pow(10.5, -1.54919),
                                                 3.0, 10.5, 0};
    const struct stochastic_drag_sigma gas = {43.9, 16.0, 16.54, 28.0, 1};

    ck_assert_double_eq_tol(stochastic_drag_sigma(&liquid, 6.0),
                            512.875 * pow(6.0, -1.54919), 1e-10);
    ck_assert_double_eq(stochastic_drag_sigma(&liquid, 1.0), liquid.low);
    ck_assert_double_eq(stochastic_drag_sigma(&liquid, 20.0), liquid.high);
    ck_assert_double_eq_tol(stochastic_drag_sigma(&gas, 22.27), 29.95, 1e-10);
}

/* --- in the coupled loop -------------------------------------------------- */

/* Numbers of the keys: sigma at both ends, Re at both, linear, time, seed. */
static struct simulation *agitated(const struct scene *s, double sigma,
                                   double T, int seed)
{
    struct simulation *const sim = build(s);
    const double numbers[] = {sigma, sigma, 1.0, 1.0, 0.0, T, seed};

    effects_create(sim, effect_named("stochastic_drag"), numbers);
    return sim;
}

/* The random part is in the coefficient that the fluid is charged with: 1e-10
 * is the tolerance of the flow solver, as without it. */
FACT_FOR_EACH(ew18_32_random_drag_keeps_the_total_momentum, 8)
{
    struct scene s = air;
    double before[3], after[3];

    s.treatment = _i & 1 ? TREATMENT_EXPLICIT : TREATMENT_SEMI_IMPLICIT;
    s.relaxation =
        _i & 2 ? SLIP_INTEGRATION_EXPONENTIAL : SLIP_INTEGRATION_FROZEN;
    s.model_b = _i & 4;
    s.substeps = 3;
    struct simulation *const sim = agitated(&s, 3.0, 1e-3, 1);
    const double scale = gross_momentum(sim);
    run(sim, 1); /* the first step takes over what was charged without it */
    coupling_total_momentum(sim, before);
    run(sim, 20);
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol((after[k] - before[k]) / scale, 0.0, 1e-9);
    discard(sim);
}

static double checksum(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += (ps->id[i] % 17 + 1) * (ps->vx[i] + 3.0 * ps->vy[i]);
    return sum;
}

/* Nothing but what is random is added: with sigma = 0 not a bit differs. */
FACT(ew18_32_without_sigma_nothing_changes)
{
    struct scene s = air;
    struct simulation *const off = build(&s),
                             *const none = agitated(&s, 0.0, 1e-3, 1),
                             *const on = agitated(&s, 3.0, 1e-3, 1),
                             *const other = agitated(&s, 3.0, 1e-3, 2);
    run(off, 10);
    run(none, 10);
    run(on, 10);
    run(other, 10);
    ck_assert_double_eq(checksum(off), checksum(none));
    ck_assert_double_ne(checksum(off), checksum(on));
    ck_assert_double_ne(checksum(other), checksum(on));
    discard(off);
    discard(none);
    discard(on);
    discard(other);
}

FACT(ew18_34_random_numbers_are_the_same_for_any_threads)
{
    struct scene s = air;
    double sum[2];

    s.n = 1200; /* more than the loops keep to one thread */
    s.size = 0.018;
    for (int k = 0; k < 2; k++) {
        omp_set_num_threads(k + 1);
        struct simulation *const sim = agitated(&s, 3.0, 1e-3, 1);
        run(sim, 10);
        sum[k] = checksum(sim);
        discard(sim);
    }
    ck_assert_double_eq(sum[0], sum[1]);
}

/* Spheres that sink at their terminal velocity in still air, one by one: the
 * variance of their velocity is that of a relaxation that such a signal forces,
 * (F'/k)^2 T / (T + tau) for short steps. Here a step is T / 2, during which
 * the force is held: with e = exp(-dt/tau) and a = exp(-dt/T), (F'/k)^2 (1 -
 * e)^2 (1 + a e) / ((1 - e^2)(1 - a e)). 400 spheres over 110 T are 400 x 110 /
 * 2 samples or more: 2 % are two standard errors. White noise, a = 0, would
 * give a third of it. */
FACT(ew18_33_a_grain_follows_as_a_relaxation_does)
{
    struct scene s = air;
    double sum = 0.0;
    long n = 0;

    s.one_way = 1;
    s.drag = "schiller-naumann";
    s.relaxation = SLIP_INTEGRATION_EXPONENTIAL;
    s.d = 2e-5;
    s.dem_steps = 1;
    s.substeps = 1;
    s.gravity[1] = -1.0;
    s.pressure_gradient = 0;
    const double tau = s.rho_s * s.d * s.d / (18.0 * s.mu), T = 0.8 * tau;
    s.dt = T / 2.0;
    const double w = tau, sigma = 0.003 * 24.0 * s.mu / (s.rho * s.d * w);
    struct simulation *const sim = agitated(&s, sigma, T, 1);
    memset(sim->fluid->u, 0,
           3 * (size_t)sim->mesh->n_cells * sizeof *sim->fluid->u);
    memset(sim->fluid->phi, 0,
           (size_t)sim->mesh->n_faces * sizeof *sim->fluid->phi);
    for (int i = 0; i < sim->particles->n; i++) {
        sim->particles->vx[i] = sim->particles->vz[i] = 0.0;
        sim->particles->vy[i] = -w;
    }
    double mean = 0.0;
    for (int k = 0; k < 240; k++) {
        run(sim, 1);
        if (k < 20) continue;
        for (int i = 0; i < sim->particles->n; i++, n++) {
            const double v = sim->particles->vy[i] + w;
            mean += v;
            sum += v * v;
        }
    }
    mean /= (double)n;
    const double e = exp(-s.dt / tau), a = exp(-s.dt / T);
    const double rms = 0.003 * w; /* of F'/k */
    const double expected = rms * rms * (1.0 - e) * (1.0 - e) * (1.0 + a * e) /
                            ((1.0 - e * e) * (1.0 - a * e));
    ck_assert_double_eq_tol((sum / (double)n - mean * mean) / expected, 1.0,
                            0.02);
    discard(sim);
}

/* A sigma of a hundred times C_d is cut at most times, and the drag still
 * pushes along the slip: no coefficient is negative or more than twice the
 * mean. */
FACT(ew18_32_a_drag_that_would_turn_round_is_cut_and_counted)
{
    struct scene s = air;
    struct effect_count c[EFFECT_COUNTS];
    struct simulation *const sim = agitated(&s, 1e4, 1e-3, 1);
    const struct effect_state *const e = &sim->effects[sim->n_effects - 1];

    run(sim, 5);
    ck_assert_int_eq(e->effect->counts(e->memory, c), 2);
    ck_assert_int_gt(c[0].value, 0);
    ck_assert_int_gt(10 * c[1].value, 8 * c[0].value);
    for (int i = 0; i < sim->particles->n; i++)
        ck_assert(sim->coupling->k[i] >= 0.0);
    discard(sim);
}
