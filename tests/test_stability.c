/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of the coupled step: the formulas compared with the program. */
#include "coupling/coupling.h"

#include "coupling/reaction.h"
#include "facts.h"
#include "suspension.h"

/* The bed of the chapter's map: eps_f = 0.45, its edge at 0.41 tau_p. */
FACT(a_packed_bed_requires_less_than_half_its_relaxation_time)
{
    ck_assert_double_eq_tol(stability_longest_step(0.45, 1.0), 0.405, 1e-12);
    ck_assert_double_eq_tol(stability_longest_step(1.0, 3.0), 6.0, 1e-12);
}

/* Where the largest factor is 1. Without an added mass q = r. With it neutral
 * spheres have half of the volume, and a tenth as heavy ones the root of q^2 -
 * 4 q + 2 r + 1 = 0, both without a share in advance. */
FACT(the_oscillation_decays_below_the_densest_packing)
{
    static const double ratio[] = {1.0, 1.0, 0.1, 0.1};
    static const struct added_mass added[] = {{0.0, 0.0}, {0.5, 0.0}};
    const double q = 2.0 - sqrt(2.8);
    const double densest[] = {0.5, 0.5, 0.1 / 1.1, q / (1.0 + q)};

    for (int i = 0; i < 4; i++) {
        const double eps_s =
            stability_max_solid_fraction(&added[i % 2], ratio[i], 1);
        ck_assert_double_eq_tol(eps_s, densest[i], 1e-12);
        ck_assert_double_eq_tol(
            stability_amplification(&added[i % 2], ratio[i], eps_s, 1), 1.0,
            1e-11);
    }
}

static double larger_root(double C, double r, double q, double s)
{
    const double b = 0.5 * q * (1.0 + 2.0 * C + s * q * C) / (r + C),
                 c = (1.0 - s) * q * q * C / (r + C), D = b * b - c;

    return D > 0.0 ? b + sqrt(D) : sqrt(c);
}

/* By a search in steps of a hundredth. Near a double root the larger one goes
 * as the root of the rounding error of s. */
FACT_FOR_EACH(no_other_share_in_advance_has_a_smaller_factor, 6)
{
    static const double ratio[] = {0.1, 1.0, 2.0, 2.65, 8.0, 2000.0};
    const double r = ratio[_i];

    for (double C = 0.1; C < 1.05; C += 0.3)
        for (double eps_s = 0.1; eps_s < 0.75; eps_s += 0.1) {
            const double q = eps_s / (1.0 - eps_s);
            const double s = reaction_share_in_advance(C, r, eps_s);
            const double least = larger_root(C, r, q, s);
            ck_assert_double_ge(s, 0.0);
            ck_assert_double_le(s, 1.0);
            for (int k = 0; k <= 100; k++)
                ck_assert_double_le(least,
                                    larger_root(C, r, q, 0.01 * k) + 1e-7);
        }
}

/* Everything at rest. */
static void stop(struct simulation *sim)
{
    struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++)
        ps->vx[i] = ps->vy[i] = ps->vz[i] = 0.0;
    for (int i = 0; i < 3 * sim->mesh->n_cells; i++)
        sim->fluid->u[i] = 0.0;
    for (int f = 0; f < sim->mesh->n_faces; f++)
        sim->fluid->phi[f] = 0.0;
    ck_assert_int_eq(coupling_start(sim), 0);
}

enum { SINKING = 14 };

/* The velocity [m/s] of a particle in the middle of the height. */
static double velocity_in_the_middle(const struct simulation *sim)
{
    const struct particles *const ps = sim->particles;
    const double half = 0.5 * sim->mesh->hi[1];
    int best = 0;

    for (int i = 1; i < ps->n; i++)
        if (fabs(ps->y[i] - half) < fabs(ps->y[best] - half)) best = i;
    return ps->vy[best];
}

/* A bed of 1024 spheres that fills a column of 16 cells begins to sink in a
 * fluid without friction. Returns its solids fraction; D [m/s] are the changes
 * of its change of velocity from step to step. */
static double sink(const struct scene *like, double ratio, double D[SINKING])
{
    struct scene s = *like;
    double v = 0.0, dv = 0.0;

    s.size = 0.006;
    s.tall = 16;
    s.n = 1024;
    s.cells = 1;
    s.d = 0.98 * s.size / 4.0; /* they do not touch in this time */
    s.averaging = "pcm";
    s.interpolation = "nearest";
    s.drag = "schiller-naumann";
    s.continuity = CONTINUITY_MIXTURE;
    s.substeps = 1;
    s.dem_steps = 1;
    s.rho = 1000.0;
    s.rho_s = ratio * s.rho;
    s.gravity[1] = -9.81;
    struct simulation *const sim = build(&s);
    stop(sim);
    for (int k = 0; k < SINKING; k++) {
        ck_assert_int_eq(coupling_step(sim), 0);
        const double next = velocity_in_the_middle(sim);
        D[k] = next - v - dv;
        dv += D[k];
        v = next;
    }
    discard(sim);
    return 64.0 * M_PI / 6.0 * gsl_pow_3(s.d / s.size);
}

/* What the sum of the terms of (20.10) leaves, over the largest of them.
 * Friction that is not quite 0 changes D by 2e-10 m/s a step, so that the terms
 * must be larger than 1e-7. */
static double left_of_20_10(const double D[SINKING], double C, double r,
                            double q, double s)
{
    double most = 0.0;
    int compared = 0;

    for (int k = 3; k < SINKING && fabs(D[k]) > 1e-7; k++) {
        const double a = (r + C) * D[k],
                     b = q * (1.0 + 2.0 * C + s * q * C) * D[k - 1],
                     c = (1.0 - s) * q * q * C * D[k - 2];
        const double size = fmax(fabs(a), fmax(fabs(b), fabs(c)));
        most = fmax(most, fabs(a + b + c) / size);
        compared++;
    }
    ck_assert_int_gt(compared, 0);
    return most;
}

FACT_FOR_EACH(a_bed_that_sinks_is_multiplied_by_the_roots_of_20_10, 3)
{
    static const double ratio[] = {1.3, 2.5, 5.0}, C[] = {0.0, 0.5};
    const double r = ratio[_i];
    double D[SINKING];

    for (int implicit = 0; implicit < 2; implicit++)
        for (int k = 0; k < 2; k++) {
            struct scene s = air;
            s.treatment =
                implicit ? TREATMENT_SEMI_IMPLICIT : TREATMENT_EXPLICIT;
            s.virtual_mass = C[k];
            s.mu = 1e-9;
            s.dt = 1e-5;
            const double eps_s = sink(&s, r, D);
            const double share =
                implicit ? reaction_share_in_advance(C[k], r, eps_s) : 0.0;
            ck_assert_double_lt(
                left_of_20_10(D, C[k], r, eps_s / (1.0 - eps_s), share), 5e-3);
        }
}

/* The growth in a step, in the mean over many, of a free bed whose steps are
 * computed one after the other as (20.9) has them, with the history force H of
 * the change of the slip in the step before: it acts on the spheres at once and
 * on the fluid a step late. */
static double growth_of_steps(double C, double H, double r, double q, double s)
{
    double du = 0.0, dv = 1.0, past = 0.0, sum = 0.0;
    enum { STEPS = 4000 };

    for (int k = 0; k < STEPS; k++) {
        const double slip = du - dv, new_du = -q * dv;
        const double G =
            new_du + q * (C * s * (new_du - du) + C * slip + H * past);
        const double new_dv = (G + C * new_du + H * slip) / (r + C);
        const double size = fabs(new_du) + fabs(new_dv) + fabs(slip);
        sum += log(size);
        du = new_du / size;
        dv = new_dv / size;
        past = slip / size;
    }
    return exp(sum / STEPS);
}

/* A double root grows as 4000 times its power, 0.2 % a step more. Where the bed
 * at rest has a larger factor, that one is given, and is not compared. */
FACT_FOR_EACH(a_bed_with_history_grows_by_the_largest_root_of_20_12, 3)
{
    static const double ratio[] = {1.3, 2.65, 8.0};
    static const struct added_mass added[] = {
        {0.5, 0.0}, {0.63, 0.11}, {0.8, 0.25}, {0.3, 0.25}};
    const double r = ratio[_i];
    int compared = 0;

    for (int k = 0; k < 4; k++)
        for (double eps_s = 0.4; eps_s < 0.65; eps_s += 0.1) {
            const double q = eps_s / (1.0 - eps_s), C = added[k].C;
            const double s = reaction_share_in_advance(C, r, eps_s);
            const double free_bed =
                growth_of_steps(C, added[k].C_history, r, q, s);
            const double found =
                stability_amplification(&added[k], r, eps_s, 1);
            if (found > 1.01 * free_bed) continue; /* the bed at rest binds */
            ck_assert_double_eq_tol(found / free_bed, 1.0, 5e-3);
            compared++;
        }
    ck_assert_int_gt(compared, 3);
}

/* Spheres that are too heavy to move, in a fluid without friction that is
 * pushed once, to 1e-5 m/s, at which the drag of the wake is small too. Without
 * a share in advance it changes in each step by -q C of the change before:
 * (20.13). */
FACT(fluid_in_a_bed_at_rest_changes_by_the_root_of_20_13)
{
    static const struct added_mass half = {0.5, 0.0};
    struct scene s = air;
    double flow[3], u = 0.0, du = 0.0;

    s.n = 512;
    s.cells = 4;
    s.averaging = "pcm";
    s.d = 0.99 * s.size / 8.0;
    s.drag = "schiller-naumann";
    s.treatment = TREATMENT_EXPLICIT;
    s.mu = 1e-9;
    s.rho_s = 1e9 * s.rho;
    s.virtual_mass = 0.5;
    const double eps_s = 512.0 * M_PI / 6.0 * gsl_pow_3(s.d / s.size);
    struct simulation *const sim = build(&s);
    stop(sim);
    ck_assert_int_eq(coupling_step(sim), 0);
    for (int c = 0; c < sim->mesh->n_cells; c++)
        sim->fluid->F[3 * c] = s.rho * 1e-5 / s.dt;
    for (int k = 0; k < 6; k++) {
        const double before = du;
        ck_assert_int_eq(coupling_step(sim), 0);
        fluid_mean_flow(sim->fluid, flow);
        du = flow[0] - u;
        u = flow[0];
        if (k > 2)
            ck_assert_double_eq_tol(
                -du / before, stability_amplification(&half, 1e9, eps_s, 0),
                1e-3);
    }
    discard(sim);
}

/* They are computed twice where particles are inserted or removed. */
FACT(drag_terms_that_are_computed_twice_are_the_same)
{
    struct scene s = air;
    const int n = s.cells * s.cells * s.cells;

    s.rho = 1000.0;
    s.rho_s = 2650.0;
    s.virtual_mass = 0.5;
    struct simulation *const sim = build(&s);
    double *const K = alloc_doubles(n);
    run(sim, 2);
    memcpy(K, sim->fluid->K, (size_t)n * sizeof *K);
    reaction_drag_terms(sim);
    for (int c = 0; c < n; c++)
        ck_assert_double_eq(sim->fluid->K[c], K[c]);
    free(K);
    discard(sim);
}

/* Charged with all of the reaction in advance, this bed in water grows by 1.4 a
 * step. */
FACT(a_bed_with_virtual_mass_and_history_in_water_is_stable)
{
    struct scene s = air;
    double D[SINKING];

    s.virtual_mass = 0.5;
    s.basset = 2e-3;
    s.mu = 1e-3;
    s.dt = 1e-4;
    sink(&s, 1.3, D);
    ck_assert_double_lt(fabs(D[SINKING - 1]), 0.2 * fabs(D[1]));
}

/* Sand in air, a solid fraction of 0.6: 1500 kg and 0.48 kg a cubic metre. */
FACT(the_loading_is_mass_beside_mass)
{
    ck_assert_double_eq_tol(stability_loading(2500.0, 0.6, 1.2), 3125.0, 1e-9);
}

/* Largest momentum of 400 light spheres in a fluid without friction, over what
 * they began with. 1 mm in 12 mm: eps_s = 0.12. Two that cross move by a radius
 * in 4e-6 s, which is 250 times as fast as any was at first. */
static double growth(double ratio, double C)
{
    struct scene s = air;

    s.substeps = 1;
    s.dem_steps = 50; /* which resolve a contact of 2e-5 s */
    s.rho = 1000.0;
    s.rho_s = ratio * s.rho;
    s.mu = 1e-9;
    s.drag = "schiller-naumann";
    s.virtual_mass = C;
    struct simulation *const sim = build(&s);
    const double before = gross_momentum(sim);
    double most = 0.0;
    for (int i = 0; i < 60 && most < 1e3; i++) {
        if (coupling_step(sim) != 0) {
            if (sim->dem_report.crossing.found) most = HUGE_VAL;
            break;
        }
        most = fmax(most, gross_momentum(sim) / before);
    }
    discard(sim);
    return most;
}

/* Below 1 nothing grows, though the spheres weigh a fiftieth of the fluid; far
 * above (the interpolation over 2 cells damps some of it) the oscillation
 * diverges, and virtual mass, which takes it from 6.9 to 0.4, stops it. */
FACT(light_spheres_are_limited_by_the_amplification_not_by_their_loading)
{
    static const struct added_mass none = {0.0, 0.0}, half = {0.5, 0.0};
    const double eps_s = 400.0 * M_PI / 6.0 / 1728.0;

    ck_assert_double_lt(stability_loading(0.15, eps_s, 1.0), 0.03);
    ck_assert_double_lt(stability_amplification(&none, 0.15, eps_s, 1), 1.0);
    ck_assert_double_lt(growth(0.15, 0.0), 1.0);
    ck_assert_double_gt(stability_amplification(&none, 0.02, eps_s, 1), 5.0);
    ck_assert_double_gt(growth(0.02, 0.0), 100.0);
    ck_assert_double_lt(stability_amplification(&half, 0.02, eps_s, 1), 0.5);
    ck_assert_double_lt(growth(0.02, 0.5), 1.0);
}

/* 64 spheres side by side in honey, one a cell, all as fast; a step lasts x of
 * their relaxation times, and the spheres weigh M times as much as the fluid.
 * What is left of the slip after 30 steps. */
static double slip_left(double x, double M, const struct scene *way)
{
    struct scene s = *way;
    double flow[3];

    s.n = 64;
    s.cells = 4;
    s.averaging = "pcm";
    s.interpolation = "nearest";
    s.drag = "schiller-naumann";
    s.pressure_gradient = 0;
    s.dem_steps = 4;
    s.mu = 100.0;
    const double eps_s = 64.0 * M_PI / 6.0 / 1728.0;
    s.rho = s.rho_s * eps_s / ((1.0 - eps_s) * M);
    s.dt = x * s.rho_s * s.d * s.d / (18.0 * s.mu);
    struct simulation *const sim = build(&s);
    struct particles *const ps = sim->particles;
    for (int i = 0; i < s.n; i++) {
        ps->vx[i] = 0.4;
        ps->vy[i] = ps->vz[i] = 0.0;
    }
    ck_assert_int_eq(coupling_start(sim), 0);
    int failed = 0;
    for (int i = 0; i < 30 && !failed; i++)
        failed = coupling_step(sim);
    fluid_mean_flow(sim->fluid, flow);
    const double slip = ps->vx[0] - flow[0] / (1.0 - eps_s);
    discard(sim);
    return failed ? INFINITY : fabs(slip) / 0.1; /* the fluid began with 0.3 */
}

static struct scene way(enum treatment treatment,
                        enum slip_integration relaxation, int substeps)
{
    struct scene s = air;

    s.treatment = treatment;
    s.relaxation = relaxation;
    s.substeps = substeps;
    return s;
}

/* A fifth of the step below and above (20.2), and the edge of the semi-implicit
 * one; the factor of a step is then 0.6 to 0.9 and 1.1 to 1.5, and 30 steps
 * make 0.04 and 20 of it at least. */
FACT_FOR_EACH(the_edges_of_the_map_lie_where_one_turn_of_the_loop_puts_them, 3)
{
    static const double loading[] = {0.01, 1.0, 100.0},
                        root[] = {1.94387, 1.0, 0.514439};
    const double M = loading[_i], edge = stability_frozen_limit(M);
    const struct scene old =
                           way(TREATMENT_EXPLICIT, SLIP_INTEGRATION_FROZEN, 1),
                       new = way(TREATMENT_SEMI_IMPLICIT,
                                 SLIP_INTEGRATION_FROZEN, 1);

    ck_assert_double_eq_tol(edge, root[_i], 1e-5);
    ck_assert_double_lt(slip_left(1.6 / (1.0 + M), M, &old), 0.05);
    ck_assert_double_gt(slip_left(2.4 / (1.0 + M), M, &old), 10.0);
    ck_assert_double_lt(slip_left(0.8 * edge, M, &new), 0.05);
    ck_assert_double_gt(slip_left(1.4 * edge, M, &new), 1.5);
}

/* The exponential has no edge, and "auto" keeps within those of its parts. */
FACT(what_relaxes_in_the_step_or_in_its_parts_is_stable)
{
    static const double loading[] = {0.1, 1.0, 10.0, 100.0};
    const struct scene exact = way(TREATMENT_SEMI_IMPLICIT,
                                   SLIP_INTEGRATION_EXPONENTIAL, 1),
                       parts = way(TREATMENT_SEMI_IMPLICIT,
                                   SLIP_INTEGRATION_FROZEN, 0);

    for (int k = 0; k < 4; k++) {
        ck_assert_double_lt(slip_left(0.8, loading[k], &exact), 0.01);
        ck_assert_double_lt(slip_left(10.0, loading[k], &exact), 0.01);
        ck_assert_double_lt(slip_left(1e4, loading[k], &exact), 1.0);
        ck_assert_double_lt(slip_left(0.8, loading[k], &parts), 0.01);
        ck_assert_double_lt(slip_left(2.5, loading[k], &parts), 0.01);
    }
}
