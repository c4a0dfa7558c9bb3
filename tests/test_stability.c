/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The limits of the coupled step: the formulas compared with the program. */
#include "coupling/stability/stability.h"

#include "facts.h"
#include "suspension.h"

/* The bed of the chapter's map: eps_f = 0.45, its edge at 0.41 tau_p. */
START_TEST(a_packed_bed_requires_less_than_half_its_relaxation_time)
{
    ck_assert_double_eq_tol(stability_longest_step(0.45, 1.0), 0.405, 1e-12);
    ck_assert_double_eq_tol(stability_longest_step(1.0, 3.0), 6.0, 1e-12);
}
END_TEST

/* Where (20.9) is 1: half of the volume for neutral spheres, with added mass
 * and without; a tenth as heavy, 0.4/1.4 with and 0.1/1.1 without it. */
START_TEST(the_oscillation_decays_below_the_densest_packing)
{
    static const double ratio[] = {1.0, 1.0, 0.1, 0.1};
    static const double C[] = {0.0, 0.5, 0.0, 0.5};
    static const double densest[] = {0.5, 0.5, 0.1 / 1.1, 0.4 / 1.4};

    for (int i = 0; i < 4; i++) {
        const double eps_s = stability_max_solid_fraction(C[i], ratio[i], 1.0);
        ck_assert_double_eq_tol(eps_s, densest[i], 1e-14);
        ck_assert_double_eq_tol(
            stability_amplification(C[i], ratio[i], eps_s, 1.0), 1.0, 1e-14);
    }
}
END_TEST

/* Sand in air, a solid fraction of 0.6: 1500 kg and 0.48 kg a cubic metre. */
START_TEST(the_loading_is_mass_beside_mass)
{
    ck_assert_double_eq_tol(stability_loading(2500.0, 0.6, 1.2), 3125.0, 1e-9);
}
END_TEST

/* Largest momentum of 400 light spheres in a fluid without friction, over what
 * they began with. 1 mm in 12 mm: eps_s = 0.12. */
static double growth(double ratio, double C)
{
    struct scene s = air;

    s.substeps = 1;
    s.rho = 1000.0;
    s.rho_s = ratio * s.rho;
    s.mu = 1e-9;
    s.drag = "schiller-naumann";
    s.virtual_mass = C;
    struct simulation *const sim = build(&s);
    const double before = gross_momentum(sim);
    double most = 0.0;
    for (int i = 0; i < 60 && most < 1e3; i++) {
        if (coupling_step(sim) != 0) break;
        most = fmax(most, gross_momentum(sim) / before);
    }
    discard(sim);
    return most;
}

/* Below 1 nothing grows, though the spheres weigh a fiftieth of the fluid; far
 * above (the interpolation over 2 cells damps some of it) the oscillation
 * diverges, and virtual mass, which takes it from 6.9 to 0.4, stops it. */
START_TEST(light_spheres_are_limited_by_the_amplification_not_by_their_loading)
{
    const double eps_s = 400.0 * M_PI / 6.0 / 1728.0;

    ck_assert_double_lt(stability_loading(0.15, eps_s, 1.0), 0.03);
    ck_assert_double_lt(stability_amplification(0.0, 0.15, eps_s, 1.0), 1.0);
    ck_assert_double_lt(growth(0.15, 0.0), 1.0);
    ck_assert_double_gt(stability_amplification(0.0, 0.02, eps_s, 1.0), 5.0);
    ck_assert_double_gt(growth(0.02, 0.0), 100.0);
    ck_assert_double_lt(stability_amplification(0.5, 0.02, eps_s, 1.0), 0.5);
    ck_assert_double_lt(growth(0.02, 0.5), 1.0);
}
END_TEST

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
START_TEST(the_edges_of_the_map_lie_where_one_turn_of_the_loop_puts_them)
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
END_TEST

/* The exponential has no edge, and "auto" keeps within those of its parts. */
START_TEST(what_relaxes_in_the_step_or_in_its_parts_is_stable)
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
END_TEST

FACTS("stability")
{
    tcase_set_timeout(facts, 60.0);
    FACT(a_packed_bed_requires_less_than_half_its_relaxation_time);
    FACT(the_oscillation_decays_below_the_densest_packing);
    FACT(the_loading_is_mass_beside_mass);
    FACT_FOR_EACH(the_edges_of_the_map_lie_where_one_turn_of_the_loop_puts_them,
                  3);
    FACT(what_relaxes_in_the_step_or_in_its_parts_is_stable);
    FACT(light_spheres_are_limited_by_the_amplification_not_by_their_loading);
}
