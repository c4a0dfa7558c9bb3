/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "averaging/cell_of_particle.h"
#include "averaging/averaging.h"
#include "coupling/coupling.h"

#include <omp.h>

#include "facts.h"
#include "suspension.h"
#include "coupling/transfer.h"

/* --- momentum ----------------------------------------------------------- */

static const struct {
    const char *averaging, *scheme;
    double cap; /* [-] more than half of the cells here exceed it */
} methods[] = {
    {"pcm", "exponential", 0.0},          {"pcm", "exponential", 0.12},
    {"kernel", "exponential", 0.0},       {"diffusion", "exponential", 0.0},
    {"diffusion", "crank-nicolson", 0.0}, {"diffusion", "implicit-euler", 0.0},
    {"diffusion", "sdirk2", 0.0},         {"dpvm", "exponential", 0.0},
    {"cube", "exponential", 0.0},         {"two-grid", "exponential", 0.0},
    {"gaussian", "exponential", 0.0},     {"images", "exponential", 0.0},
    {"diffusion", "series", 0.0}};
enum { METHODS = sizeof methods / sizeof *methods };
static const char *const ways[] = {"nearest", "linear", "same"};
static const int drag_updates[] = {1, 3, 0};

/* Decodes one choice out of n from a number. */
static int pick(int *left, int n)
{
    const int choice = *left % n;

    *left /= n;
    return choice;
}

/* One of the 192 ways to combine all else: treatment, continuity, pressure not
 * at all, by model A or B or in the whole drag, relaxation, virtual mass with
 * the viscous stress, sub-steps 1, 3, auto. */
static struct scene combination(int number)
{
    struct scene s = air;

    s.n = 125; /* a small cube of a light liquid */
    s.cells = 4;
    s.size = 0.008;
    s.width = 1.0;
    s.rho = 100.0;
    s.mu = 1e-3;
    s.treatment =
        pick(&number, 2) ? TREATMENT_EXPLICIT : TREATMENT_SEMI_IMPLICIT;
    s.continuity = pick(&number, 2) ? CONTINUITY_MIXTURE : CONTINUITY_VOID_RATE;
    const int pressure = pick(&number, 4);
    s.pressure_gradient = pressure == 1 || pressure == 2;
    s.model_b = pressure == 2;
    s.whole_drag = pressure == 3;
    s.relaxation = pick(&number, 2) ? SLIP_INTEGRATION_EXPONENTIAL
                                    : SLIP_INTEGRATION_FROZEN;
    s.viscous_stress = pick(&number, 2);
    s.virtual_mass = 0.5 * s.viscous_stress;
    s.substeps = drag_updates[pick(&number, 3)];
    return s;
}

/* [XS11 Algorithm 3.1] three times: the sum of the momenta of fluid and
 * particles and the unpaid impulse is constant to rounding. 1e-12 of the
 * particles' momentum is a thousand roundings; the solvers of the diffusion get
 * 1e-10, a thousand times their tolerance. */
static void check_momentum(const struct scene *s)
{
    double before[3], after[3];
    struct simulation *const sim = build(s);
    coupling_total_momentum(sim, before);
    const double scale = gross_momentum(sim) + fabs(before[0]);
    run(sim, 3);
    ck_assert_int_eq(averaging_report(sim->averaging)->capped > 9,
                     s->cap > 0.0);
    coupling_total_momentum(sim, after);
    const int sure = strcmp(s->scheme, "exponential") == 0 ||
                     strcmp(s->scheme, "series") == 0;
    const double limit = sure ? 1e-12 : 1e-10;
    for (int k = 0; k < 3; k++) {
        const double drift = after[k] - before[k] - sim->fluid->relabelled[k];
        ck_assert_msg(fabs(drift) < limit * scale, "%s %s %s: drift %g",
                      s->averaging, s->scheme, s->interpolation, drift / scale);
    }
    ck_assert_double_lt(sim->coupling->report.exchange_residual, limit);
    discard(sim);
}

/* Every method of averaging with every interpolation, and with 8 of the 192.
 * With the strides 7 and 19 any two choices occur together. */
FACT_FOR_EACH(xs11_3_18_total_momentum_is_constant_for_every_combination,
              3 * METHODS)
{
    for (int j = 0; j < 8; j++) {
        struct scene s = combination((7 * _i + 19 * j) % 192);
        s.averaging = methods[_i % METHODS].averaging;
        s.scheme = methods[_i % METHODS].scheme;
        s.cap = methods[_i % METHODS].cap;
        s.interpolation = ways[_i / METHODS];
        s.time = time_schemes[j / 4];
        check_momentum(&s);
    }
}

/* Spheres alone in cells half as wide as they are: their volume is 3.6 times
 * that of the cell, and 0.7 of it is counted. A force proportional to the whole
 * volume would be amplified by up to 3.6/0.3 a step. Nothing drives the flow,
 * so no velocity may exceed twice the 0.3 m/s it begins with: model A and model
 * B, and the virtual mass. */
FACT_FOR_EACH(volume_above_a_cap_has_no_volume_force, 3)
{
    struct scene s = air;
    s.averaging = "pcm";
    s.cap = 0.7;
    s.n = 64;
    s.cells = 8;
    s.size = 0.008;
    s.d = 1.9e-3;
    s.continuity = CONTINUITY_MIXTURE;
    s.model_b = _i == 1;
    s.virtual_mass = _i == 2 ? 0.5 : 0.0;
    struct simulation *const sim = build(&s);

    for (int i = 0; i < s.n; i++)
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
    run(sim, 40);
    ck_assert_int_eq(averaging_report(sim->averaging)->capped, 64);
    for (int c = 0; c < 3 * sim->mesh->n_cells; c++)
        ck_assert_double_lt(fabs(sim->fluid->u[c]), 0.6);
    discard(sim);
}

/* The viscous force of a wavy stream on the first of 64 spheres, one a cell and
 * 0.7 of its volume, with this cap. */
static double viscous_push(double cap)
{
    struct scene s = air;
    s.averaging = "pcm";
    s.cap = cap;
    s.n = 64;
    s.cells = 8;
    s.size = 0.008;
    s.d = 1.1e-3;
    s.pressure_gradient = 0;
    s.viscous_stress = 1;
    struct simulation *const sim = build(&s);

    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->u[3 * c] =
            sin(2.0 * M_PI * sim->mesh->centre[3 * c + 1] / s.size);
    sim->effects[0].effect->before_particles(sim->effects[0].memory, sim);
    const double push = sim->held_force[0];
    discard(sim);
    return push;
}

FACT(a_cap_counts_the_same_share_of_the_viscous_stress)
{
    const double share = 0.35 / (M_PI / 6.0 * 1.331);
    const double whole = viscous_push(0.0);

    ck_assert_double_gt(fabs(whole), 0.0);
    ck_assert_double_eq_tol(viscous_push(0.35) / whole, share, 1e-12);
}

/* What is summed over 2744 spheres, enough for several ranges of them, after
 * three steps with so many threads. */
static void sums_by_threads(int threads, double sums[5])
{
    struct scene s = air;
    s.n = 2744;
    s.cells = 4;
    s.size = 0.03;
    s.pressure_gradient = 1;
    omp_set_num_threads(threads);
    struct simulation *const sim = build(&s);

    run(sim, 3);
    const struct effect_tally *const t = &sim->effects[0].tally;
    const double all[5] = {t->sum, t->largest, t->weight, sim->force_scale.sum,
                           sim->coupling->report.exchange_residual};
    memcpy(sums, all, sizeof all);
    discard(sim);
    omp_set_num_threads(1);
}

FACT(sums_over_particles_have_the_same_bits_for_any_threads)
{
    static const int threads[] = {1, 2, 3, 7};
    double sums[4][5];

    for (int k = 0; k < 4; k++) {
        sums_by_threads(threads[k], sums[k]);
        ck_assert_double_eq(sums[k][2], 3.0 * 2744.0);
        for (int j = 0; j < 5; j++)
            ck_assert_double_eq(sums[k][j], sums[0][j]);
    }
    for (int j = 0; j < 5; j++)
        ck_assert_double_gt(sums[0][j], 0.0);
}

/* Nothing but weight less buoyancy, (m - rho_f V_p) g, comes from outside, also
 * where a cap counts part of V_p only. No sphere changes cells in the 0.6 ms;
 * the rest is rounding. */
FACT_FOR_EACH(a_cap_leaves_the_whole_buoyancy_in_both_models, 2)
{
    struct scene s = air;
    double before[3], after[3];
    s.averaging = "pcm";
    s.cap = 0.05;
    s.rho = 100.0;
    s.gravity[1] = -9.81;
    s.model_b = _i;
    struct simulation *const sim = build(&s);
    const double pull = (s.rho_s - s.rho) * M_PI / 6.0 * gsl_pow_3(s.d) * -9.81;

    for (int i = 0; i < s.n; i++)
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
    run(sim, 1); /* the unpaid impulse of the first step follows from the
                    velocities */
    coupling_total_momentum(sim, before);
    run(sim, 3);
    coupling_total_momentum(sim, after);
    ck_assert_int_gt(averaging_report(sim->averaging)->capped, 9);
    ck_assert_double_eq_tol((after[1] - before[1]) / (s.n * pull * 3.0 * s.dt),
                            1.0, 1e-9);
    discard(sim);
}

/* [SX15 section 3.4]: no field of eps_s u_s is computed unless it is needed.
 * The field is then that of the other form, and what is averaged is V_p u_p
 * [SX15 9, XS11 3.12]. */
FACT(the_void_rate_form_averages_the_solids_velocity_on_demand)
{
    struct scene s = air;
    struct simulation *const lazy = build(&s);
    s.continuity = CONTINUITY_MIXTURE;
    struct simulation *const full = build(&s);
    const int n = lazy->mesh->n_cells;

    for (int c = 0; c < 3 * n; c++)
        ck_assert(lazy->fluid->eps_us[c] == 0.0);
    transfer_solids_velocity(lazy);
    transfer_solids_velocity(full); /* has it already */
    for (int c = 0; c < 3 * n; c++)
        ck_assert_double_eq_tol(lazy->fluid->eps_us[c], full->fluid->eps_us[c],
                                1e-13);
    for (int c = 0; c < n; c++)
        ck_assert_double_eq_tol(lazy->fluid->eps[c], full->fluid->eps[c],
                                1e-14);
    discard(lazy);
    discard(full);
}

/* Sampling does not change the run. */
FACT(sampling_the_solids_velocity_does_not_change_the_run)
{
    struct simulation *const a = build(&air), *const b = build(&air);

    for (int i = 0; i < 5; i++) {
        run(a, 1);
        run(b, 1);
        transfer_solids_velocity(b);
    }
    ck_assert_mem_eq(a->fluid->u, b->fluid->u,
                     3 * (size_t)a->mesh->n_cells * sizeof(double));
    ck_assert_mem_eq(a->particles->vx, b->particles->vx,
                     (size_t)a->particles->n * sizeof(double));
    discard(a);
    discard(b);
}

/* [XS11 Algorithm 3.1] as printed charges the fluid with Omega and A of the
 * step before and drops the difference, which is the sum of
 * `unpaid_impulse`. */
FACT(without_the_unpaid_impulse_algorithm_3_1_loses_momentum)
{
    struct simulation *const sim = build(&air);
    double unpaid[3];
    run(sim, 20);
    coupling_unpaid_impulse(sim, unpaid);
    /* a hundred times what the test above allows */
    ck_assert_double_gt(fabs(unpaid[0]), 1e-10 * gross_momentum(sim));
    discard(sim);
}

/* The drag of a sub-step with fixed k pulls as the mean velocity would: the
 * impulse is k (u_f - mean u_p) dt, and N_s = 1 has the velocity of the start.
 * One sphere by Schiller and Naumann at Re = 7e-7, where k is 3 pi mu d and
 * 0.15 Re^0.687 = 1e-5 more. */
FACT(xs11_3_20_impulse_follows_the_mean_velocity_of_the_sub_steps)
{
    struct scene s = air;
    s.n = 1;
    s.d = 1e-5;
    s.size = 1e-3;
    s.drag = "schiller-naumann";
    s.averaging = "pcm";
    s.substeps = 5;
    s.pressure_gradient = 0;
    struct simulation *const sim = build(&s);
    struct particles *const ps = sim->particles;
    const double v0 = 1e-6, m = ps->m[0];
    const double k = 3.0 * M_PI * s.mu * s.d;
    memset(sim->fluid->u, 0, 3 * (size_t)sim->mesh->n_cells * sizeof(double));
    memset(sim->fluid->phi, 0, (size_t)sim->mesh->n_faces * sizeof(double));
    ps->vx[0] = v0;
    ps->vy[0] = ps->vz[0] = 0.0;
    ck_assert_int_eq(coupling_start(sim), 0);
    run(sim, 1);
    /* v^(j+1) = v^j + k (u - v^j) dt_s / m, and the mean over j = 0..4 */
    double v = v0, mean = 0.0;
    const double u = sim->coupling->u_f[0];
    for (int j = 0; j < 5; j++) {
        mean += v / 5.0;
        v += k * (u - v) * s.dt / 5.0 / m;
    }
    ck_assert_double_eq_tol(sim->coupling->u_mean[0] / mean, 1.0, 1e-5);
    ck_assert_double_eq_tol(m * (ps->vx[0] - v0) /
                                (k * (u - sim->coupling->u_mean[0]) * s.dt),
                            1.0, 2e-5);
    discard(sim);
}

/* What acts on the fluid of a cell in the next step is what the spheres in it
 * have got from the fluid, per volume and with the other sign. No spheres
 * touch, and explicit treatment charges all of it a step late. */
FACT(sx15_8_the_force_on_the_fluid_is_minus_that_on_the_particles)
{
    struct scene s = air;
    s.averaging = "pcm";
    s.treatment = TREATMENT_EXPLICIT;
    s.pressure_gradient = 0;
    struct simulation *const sim = build(&s);
    const struct particles *const ps = sim->particles;
    const struct mesh *const mesh = sim->mesh;
    double *const sum = alloc_doubles(mesh->n_cells), before[400];

    for (int i = 0; i < s.n; i++)
        before[ps->id[i]] = ps->vx[i];
    run(sim, 1);
    for (int i = 0; i < s.n; i++)
        sum[mesh_cell_at(mesh, ps->x[i], ps->y[i], ps->z[i])] +=
            ps->m[i] * (ps->vx[i] - before[ps->id[i]]) / s.dt;
    for (int c = 0; c < mesh->n_cells; c++)
        ck_assert_double_eq_tol(sim->fluid->F[3 * c], -sum[c] / mesh->V[c],
                                1e-10 * 400.0);
    ck_assert_double_gt(fabs(sim->fluid->F[0]), 4.0);
    free(sum);
    discard(sim);
}

/* By all cells, of which each has its nearest image: sum K u / sum K. */
FACT(xs11_3_9a_the_velocity_at_a_particle_is_the_mean_by_the_kernel)
{
    struct scene s = air;
    s.averaging = "kernel";
    struct simulation *const sim = build(&s);
    const struct mesh *const mesh = sim->mesh;
    const struct particles *const ps = sim->particles;
    const double b = s.width * s.size / s.cells;

    for (int j = 0; j < 3 * mesh->n_cells; j++)
        sim->fluid->u[j] = sin(1.7 * j);
    transfer_fluid(sim);
    for (int i = 0; i < s.n; i++) {
        const double x[3] = {ps->x[i], ps->y[i], ps->z[i]};
        double sum = 0.0, mean[3] = {0.0, 0.0, 0.0};
        for (int c = 0; c < mesh->n_cells; c++) {
            double r2 = 0.0;
            for (int k = 0; k < 3; k++)
                r2 += gsl_pow_2(
                    remainder(x[k] - mesh->centre[3 * c + k], s.size));
            const double K = kernel_polynomial(sqrt(r2) / b);
            sum += K;
            for (int k = 0; k < 3; k++)
                mean[k] += K * sim->fluid->u[3 * c + k];
        }
        for (int k = 0; k < 3; k++)
            ck_assert_double_eq_tol(sim->coupling->u_f[3 * i + k],
                                    mean[k] / sum, 1e-13);
    }
    discard(sim);
}

/* tau_p of 0.1 mm in water is 0.56 ms: a step of 5 ms requires 9 to 10 drag
 * updates, and 20 particle steps allow them. */
FACT(xs11_3_16_auto_takes_as_many_sub_steps_as_tau_requires)
{
    struct scene s = air;
    s.rho = 1000.0;
    s.mu = 1e-3;
    s.d = 1e-4;
    s.n = 8;
    s.drag = "schiller-naumann";
    s.dt = 5e-3;
    s.dem_steps = 20;
    struct simulation *const sim = build(&s);
    for (int i = 0; i < s.n; i++)
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
    run(sim, 3);
    const double tau = sim->coupling->report.shortest_time;
    ck_assert_double_lt(tau, 0.56e-3);
    ck_assert_int_eq(sim->coupling->report.substeps, (int)ceil(5e-3 / tau));
    discard(sim);
}

/* A free sphere in a stream, one-way: after a step of any length the
 * exponential integration gives the exact solution for the k of the start, and
 * frozen drag gives one Euler step. To rounding. */
FACT_FOR_EACH(xs11_3_16_relaxation_is_exact_for_a_constant_rate, 10)
{
    static const double steps_over_tau[] = {1e-3, 0.1, 1.0, 3.0, 100.0};
    const int exact = _i % 2;
    struct scene s = air;
    s.n = s.one_way = s.substeps = s.dem_steps = 1;
    s.pressure_gradient = 0;
    s.relaxation =
        exact ? SLIP_INTEGRATION_EXPONENTIAL : SLIP_INTEGRATION_FROZEN;
    s.rho_s = 1000.0;
    s.d = 1e-4;
    s.drag = "schiller-naumann";
    struct simulation *sim = build(&s);
    run(sim, 1); /* for the rate at rest in the stream */
    s.dt *= steps_over_tau[_i / 2] * sim->coupling->report.shortest_time / s.dt;
    discard(sim);
    sim = build(&s);
    const double v0[3] = {sim->particles->vx[0], sim->particles->vy[0],
                          sim->particles->vz[0]};
    const double slip =
        sqrt(pow(0.3 - v0[0], 2) + v0[1] * v0[1] + v0[2] * v0[2]);
    const double x =
        s.dt / sim->particles->m[0] * M_PI / 6.0 * pow(s.d, 3) *
        drag_resistance(drag_law_named(s.drag), 1.0, s.rho, s.mu, s.d, slip);
    run(sim, 1);
    const double gained = exact ? -expm1(-x) : x;
    ck_assert_double_eq_tol(sim->particles->vx[0] - v0[0],
                            gained * (0.3 - v0[0]), 1e-12 * (1.0 + x));
    ck_assert_double_eq_tol(sim->particles->vy[0] - v0[1], -gained * v0[1],
                            1e-12 * (1.0 + x));
    ck_assert_double_eq_tol(sim->coupling->u_mean[0], /* f = k (u - v_mean) */
                            0.3 - (0.3 - v0[0]) * gained / x, 1e-12);
    discard(sim);
}

/* --- forces ------------------------------------------------------------- */

/* The force on a particle is V_p beta / eps_s times the slip, along the
 * velocity of the fluid relative to the particle (printed the other way round).
 * One step without contacts: the velocity changes along the slip of its start,
 * to rounding. */
FACT(xs11_2_9_drag_is_along_the_slip_of_the_fluid)
{
    struct scene s = air;
    s.averaging = "pcm";
    s.interpolation = "nearest";
    s.pressure_gradient = 0;
    s.substeps = s.dem_steps = 1;
    s.n = 27;
    struct simulation *const sim = build(&s);
    const double eps_s = 1.0 - sim->coupling->eps[13];
    double w[3] = {0.3 - sim->particles->vx[13], -sim->particles->vy[13],
                   -sim->particles->vz[13]};
    const double slip = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    const double beta =
        drag_beta(drag_law_named(s.drag), eps_s, s.rho, s.mu, s.d, slip);
    ck_assert_double_eq_tol(sim->coupling->k[13] * eps_s /
                                (M_PI / 6.0 * pow(s.d, 3) * beta),
                            1.0, 1e-12);
    const double *const v[3] = {sim->particles->vx, sim->particles->vy,
                                sim->particles->vz};
    double before[3], along = 0.0, gained = 0.0;
    for (int k = 0; k < 3; k++)
        before[k] = v[k][13];
    run(sim, 1);
    for (int k = 0; k < 3; k++) { /* the fluid has moved on a little, too */
        w[k] = sim->coupling->u_f[39 + k] - before[k];
        along += w[k] * (v[k][13] - before[k]);
        gained += pow(v[k][13] - before[k], 2);
    }
    ck_assert_double_gt(along, 0.0);
    ck_assert_double_eq_tol(
        along / sqrt(gained * (w[0] * w[0] + w[1] * w[1] + w[2] * w[2])), 1.0,
        1e-12);
    discard(sim);
}

/* Cell by cell, from the particles in it and their k alone. */
FACT(xs11_3_15_omega_and_a_are_sums_over_the_particles_of_a_cell)
{
    struct scene s = air;
    s.averaging = "pcm";
    struct simulation *const sim = build(&s);
    const struct particles *const ps = sim->particles;
    const int *const host = averaging_cells(sim->averaging)->cell;
    for (int c = 0; c < sim->mesh->n_cells; c++) {
        double K = 0.0, F = 0.0;
        for (int i = 0; i < ps->n; i++)
            if (host[i] == c) {
                K += sim->coupling->k[i] / sim->mesh->V[c];
                F += sim->coupling->k[i] * ps->vx[i] / sim->mesh->V[c];
            }
        ck_assert_double_eq_tol(sim->fluid->K[c], K, 1e-12 * (1.0 + K));
        ck_assert_double_eq_tol(sim->fluid->F[3 * c], F, 1e-12 * (1.0 + K));
    }
    discard(sim);
}

/* 1000 Pa/m in every cell, spheres of three sizes: - V_p grad p on each. The
 * fluid is at rest and so is its viscous stress. */
FACT(xs11_2_6_a_pressure_gradient_pushes_by_the_volume)
{
    struct scene s = air;
    s.n = 27;
    struct simulation *const sim = build(&s);
    const struct effect_state *const e = &sim->effects[0];
    for (int i = 0; i < s.n; i++)
        sim->particles->d[i] *= 1.0 + 0.25 * (i % 3);
    for (int c = 0; c < 3 * sim->mesh->n_cells; c++)
        sim->fluid->grad_p[c] = c % 3 == 1 ? 1000.0 : 0.0;
    memset(sim->held_force, 0, 3 * (size_t)s.n * sizeof *sim->held_force);
    e->effect->before_particles(e->memory, sim);
    for (int i = 0; i < s.n; i++) {
        const double V = M_PI / 6.0 * pow(sim->particles->d[i], 3);
        ck_assert_double_eq_tol(sim->held_force[3 * i + 1] / (-1000.0 * V), 1.0,
                                1e-12);
        ck_assert_double_eq_tol(sim->held_force[3 * i], 0.0,
                                1e-12 * 1000.0 * V);
    }
    discard(sim);
}

/* Two cells beside each other 0.85 and 0.92 full, all else empty: the slope of
 * eps_f in the first is -0.459 over its width (half of 0.15 - 1 and half of
 * 0.084 - 0.15), and near its far side there is less than nothing. */
FACT(a_sphere_with_no_interpolated_fluid_ends_the_run)
{
    struct scene s = air;
    s.averaging = "pcm";
    s.interpolation = "linear";
    s.n = 27;
    struct simulation *const sim = build(&s);
    struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        ps->x[i] = i < 13 ? 5e-3 : 7e-3;
        ps->y[i] = ps->z[i] = 5e-3;
    }
    ck_assert_int_eq(transfer_average(sim), 0);
    ps->x[0] = 5.9e-3;
    ck_assert_int_ne(transfer_average(sim), 0);
    ck_assert_double_eq_tol(sim->coupling->report.eps_lowest, 0.0837, 1e-3);
    ck_assert_double_eq_tol(sim->coupling->report.lowest_interpolated,
                            0.149 - 0.45 * 0.459, 2e-3);
    discard(sim);
}

/* A sphere as heavy as the fluid floats: weight and buoyancy cancel in each
 * step, for any g, while the pressure has no hydrostatic part. */
FACT(ls_5_1_a_neutral_sphere_floats)
{
    struct scene s = air;
    s.rho = s.rho_s;
    s.gravity[1] = -9.81;
    s.n = 27;
    struct simulation *const sim = build(&s);
    memset(sim->fluid->u, 0, 3 * (size_t)sim->mesh->n_cells * sizeof(double));
    memset(sim->fluid->phi, 0, (size_t)sim->mesh->n_faces * sizeof(double));
    for (int i = 0; i < s.n; i++)
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
    coupling_start(sim);
    run(sim, 50);
    for (int i = 0; i < s.n; i++) /* rounding of 9.81 * 0.01 s */
        ck_assert_double_lt(fabs(sim->particles->vy[i]), 1e-15);
    discard(sim);
}

/* A bed that is held, 0.5487 of it grains of 1 mm, in a gas of 10 kg/m^3 and
 * 1.5e-3 Pa s: over 15.6 mm Ergun has 22.992 Pa at 2 mm/s and 230.507 Pa at 20
 * mm/s. Driven by these, the fluid comes to these speeds, in both forms of the
 * momentum equation, to 1e-4: four of the five digits of the drops, which a
 * constant of the law that is off by a thousandth would miss. */
FACT_FOR_EACH(ls_5_27_a_fixed_bed_has_erguns_pressure_drop, 4)
{
    static const double drop[] = {22.992, 230.507}, speed[] = {2e-3, 2e-2};
    struct scene s = air;
    double flow[3];
    s.averaging = "pcm";
    s.interpolation = "nearest";
    s.drag = "gidaspow";
    s.rho = 10.0;
    s.mu = 1.5e-3;
    s.n = 8 * 8 * 8;
    s.cells = 4;
    s.size = 8 * 1e-3 * cbrt(M_PI / 6.0 / (1.0 - 0.451335));
    s.substeps = s.dem_steps = 1;
    s.model_b = _i / 2;
    s.mean_gradient = -drop[_i % 2] / 0.0156;
    struct simulation *const sim = build(&s);
    for (int i = 0; i < s.n; i++) {
        sim->particles->vx[i] = sim->particles->vy[i] = sim->particles->vz[i] =
            0.0;
        sim->particles->m[i] *= 1e12;
    }
    ck_assert_int_eq(coupling_start(sim), 0);
    run(sim, 40);
    ck_assert_double_eq_tol(sim->fluid->eps[0], 0.451335, 1e-12);
    fluid_mean_flow(sim->fluid, flow);
    ck_assert_double_eq_tol(flow[0] / speed[_i % 2], 1.0, 1e-4);
    discard(sim);
}

/* One-way: the fluid is what it would be alone, bit for bit. */
FACT(ls_5_one_way_leaves_the_fluid_alone)
{
    struct scene s = air;
    s.one_way = 1;
    s.pressure_gradient = 0;
    struct simulation *const sim = build(&s);
    run(sim, 10);
    for (int c = 0; c < sim->mesh->n_cells; c++) {
        ck_assert_double_eq_tol(sim->fluid->u[3 * c], 0.3, 1e-15);
        ck_assert_double_eq(sim->fluid->eps[c], 1.0);
    }
    ck_assert_double_eq(sim->coupling->report.eps_lowest, 1.0);
    double mean = 0.0;
    for (int i = 0; i < s.n; i++)
        mean += sim->particles->vx[i] / s.n;
    ck_assert_double_gt(mean,
                        0.24); /* the force on the particles is not zero */
    discard(sim);
}

/* --- hard cases ----------------------------------------------------------- */

/* Heavy, tiny, many: dt / tau_p of 1e4 and a mass loading of 500. The semi-
 * implicit step must stay bounded by the velocities it started with. */
FACT_FOR_EACH(xs11_3_14_semi_implicit_drag_is_stable_at_dt_1e4_tau, 3)
{
    struct scene s = air;
    s.averaging = methods[_i].averaging;
    s.scheme = methods[_i].scheme;
    s.mu = 18.0; /* honey */
    s.rho = 1.0;
    s.dt = 1e-3;
    s.dem_steps = 10; /* none moves by more than its radius in one */
    s.substeps = 1;
    struct simulation *const sim = build(&s);
    for (int i = 0; i < s.n; i++) /* held: only the fluid reacts */
        sim->particles->m[i] *= 1e12;
    run(sim, 30);
    for (int i = 0; i < 3 * sim->mesh->n_cells; i++)
        ck_assert_double_lt(fabs(sim->fluid->u[i]), 2.0);
    discard(sim);
}

/* Two spheres touch at the start of a step and are apart at its end, after
 * pi sqrt(m* / k) = 0.16 of its 0.2 ms; v sqrt(m* / k) is 0.05 of a diameter.
 */
FACT(a_step_of_several_sub_steps_reports_its_deepest_overlap)
{
    struct scene s = air;
    s.n = 2;
    s.substeps = 4;
    struct simulation *const sim = build(&s);
    struct particles *const ps = sim->particles;

    for (int i = 0; i < 2; i++) {
        ps->x[i] = 0.006 + (i == 0 ? -0.0005 : 0.0005);
        ps->y[i] = ps->z[i] = 0.006;
        ps->vx[i] = i == 0 ? 0.5 : -0.5;
        ps->vy[i] = ps->vz[i] = 0.0;
    }
    dem_changed(sim->dem);
    ck_assert_int_eq(coupling_start(sim), 0);
    run(sim, 1);
    ck_assert_int_eq((int)sim->dem_report.steps, s.dem_steps);
    ck_assert_double_gt(sim->dem_report.max_overlap, 0.04);
    discard(sim);
}

FACT(the_coupled_loop_gives_the_same_bits_for_any_number_of_threads)
{
    double u[2][3 * 216], x[2][400];
    const int most = omp_get_max_threads();
    for (int k = 0; k < 2; k++) {
        omp_set_num_threads(k + 1);
        struct simulation *const sim = build(&air);
        run(sim, 30);
        memcpy(u[k], sim->fluid->u, sizeof u[k]);
        memcpy(x[k], sim->particles->x, sizeof x[k]);
        discard(sim);
    }
    omp_set_num_threads(most);
    ck_assert_mem_eq(u[0], u[1], sizeof u[0]);
    ck_assert_mem_eq(x[0], x[1], sizeof x[0]);
}
