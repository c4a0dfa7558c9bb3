/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laws of a stress in the place of contacts, and what collisions do
 * besides. The rest are facts of runs: tests/tables/stress.txt. */
#include "base/alloc.h"
#include "coupling/effects/forces.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "averaging/hats.h"
#include "base/statistics.h"
#include "case/build.h"
#include "case/case_file.h"
#include "coupling/coupling.h"

#include "facts.h"

static const struct particle_stress_law laws[] = {
    {.exponent = 2.0, .packing = 0.6},
    {.exponent = 3.0, .packing = 0.64},
    {.lun = 1, .packing = 0.6, .e = 0.9}};

static const double fractions[] = {1e-6, 0.01, 0.3, 0.55, 0.599, 0.5999999};
enum { FRACTIONS = sizeof fractions / sizeof *fractions };

FACT_FOR_EACH(a_stress_has_its_fraction_and_its_slope, 3)
{
    const struct particle_stress_law *const law = &laws[_i];

    for (int k = 0; k < FRACTIONS; k++) {
        const double eps = fractions[k], tau = particle_stress(law, 7.0, eps);
        const double h = 1e-3 * fmin(eps, law->packing - eps);
        const double slope = (particle_stress(law, 7.0, eps + h) -
                              particle_stress(law, 7.0, eps - h)) /
                             (2.0 * h);
        ck_assert_double_eq_tol(particle_stress_fraction(law, 7.0, tau) / eps,
                                1.0, 1e-10);
        ck_assert_double_eq_tol(particle_stress_slope(law, 7.0, eps) / slope,
                                1.0, 1e-5);
    }
}

/* For a stress of any size the fraction is below that of the packing. */
FACT_FOR_EACH(no_stress_is_too_large_for_the_packing, 3)
{
    for (double tau = 1e-320; tau < 1e12; tau *= 10.0) {
        const double eps = particle_stress_fraction(&laws[_i], 1e-3, tau);
        if (tau > 1e-300) ck_assert_double_gt(eps, 0.0);
        ck_assert_double_ge(eps, 0.0);
        ck_assert_double_le(eps, laws[_i].packing);
    }
}

/* Two facts by hand: 0.4^2 P/0.2; and of elastic grains Z = 1 + 4 eps g_0, of
 * which a source that halves the collisions has 1 + 2 eps g_0. */
FACT(snider01_lun84_stresses_have_their_values)
{
    const struct particle_stress_law elastic = {
        .lun = 1, .packing = 0.6, .e = 1.0};
    const double g_0 = 0.6 / (1.0 - 0.5); /* of an eighth of the packing */

    ck_assert_double_eq_tol(particle_stress(&laws[0], 10.0, 0.4), 8.0, 1e-13);
    ck_assert_double_eq_tol(particle_stress(&elastic, 10.0, 0.075),
                            0.75 * (1.0 + 4.0 * 0.075 * g_0), 1e-13);
}

enum { GAS = 2560 }; /* 40 a cell, a fifth of the volume */

/* A gas of 1 mm in a periodic box, with this stress and effect; velocities are
 * normal, of 1 m/s along x, y, z times `wide`. */
static struct simulation *gas(double pressure, const char *effect,
                              const double wide[3])
{
    const double L = cbrt(GAS * M_PI / 6.0 * 1e-9 / 0.2);
    char path[] = "/tmp/winnow-gas-XXXXXX";
    FILE *const f = fdopen(mkstemp(path), "w");
    int code;

    fprintf(
        f,
        "mesh = { size = [%.17g, %.17g, %.17g]; cells = [4, 4, 4];\n"
        "  periodic = [true, true, true]; };\n"
        "particles = { contact = \"linear\"; step = 1e-4; list = \"none\";\n"
        "  overlaps = \"allow\"; grains = { density = 1000; stiffness = 1.0;\n"
        "  restitution = 0.9; friction = 0.0; };\n  place = (\n",
        L, L, L);
    for (int i = 0; i < GAS; i++)
        fprintf(f,
                "{ position = [%.9g, %.9g, %.9g]; diameter = 1e-3;\n"
                " velocity = [%.9g, %.9g, %.9g]; }%s\n",
                L * random_uniform(7, i, 0, 0), L * random_uniform(7, i, 0, 1),
                L * random_uniform(7, i, 0, 2),
                wide[0] * random_normal(7, i, 1, 0),
                wide[1] * random_normal(7, i, 1, 1),
                wide[2] * random_normal(7, i, 1, 2), i < GAS - 1 ? "," : "");
    fprintf(f,
            "); };\neffects = { particle_stress = { pressure = %g; };\n"
            "  %s };\noutput = { end = 1.0; every = 1.0; };\n",
            pressure, effect);
    fclose(f);
    struct settings *const s = case_file_read(path, 0, NULL, &code);
    remove(path);
    ck_assert_ptr_nonnull(s);
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_ptr_nonnull(sim);
    settings_free(s);
    ck_assert_int_eq(coupling_start(sim), 0);
    return sim;
}

/* Sum of the squares of the velocities of a direction, and of the velocities.
 */
static double square_sum(const struct simulation *sim, int k, double *sum)
{
    const struct particles *const ps = sim->particles;
    const double *const v[3] = {ps->vx, ps->vy, ps->vz};
    double squares = 0.0;

    *sum = 0.0;
    for (int i = 0; i < ps->n; i++) {
        *sum += v[k][i];
        squares += v[k][i] * v[k][i];
    }
    return squares;
}

/* Theta^(-1/2) grows by (1 - e^2)(4/sqrt(pi)) eps g_0/d in time [Haff83]. 3 %:
 * the mean of the 67 particles that a cell sees follows each, 1.5 %, and eps
 * scatters. The small momentum of a direction keeps its size. */
FACT(haff83_orourke10_damping_follows_haffs_law)
{
    struct simulation *const sim =
        gas(1e-9, "collision_damping = { restitution = 0.9; };",
            (double[3]){1, 1, 1});
    const double slope = (1.0 - 0.81) * 4.0 / sqrt(M_PI) * 0.2 * 1.5 / 1e-3;
    const double before = square_sum(sim, 0, &(double){0.0});
    double sum, was;

    square_sum(sim, 1, &was);
    for (int k = 0; k < 200; k++)
        ck_assert_int_eq(coupling_step(sim), 0);
    const double ratio = sqrt(before / square_sum(sim, 0, &sum));
    ck_assert_double_eq_tol((ratio - 1.0) / (slope * 0.02), 1.0, 0.03);
    square_sum(sim, 1, &sum);
    ck_assert_double_eq_tol(sum, was, 1e-12 * GAS);
    build_free(sim);
}

/* What one direction has more than another falls at the rate p/mu = 96/(5
 * sqrt(pi)) eps g_0 sqrt(Theta)/d, while the energy stays. 6 %: of 2560 numbers
 * the mean square of each direction is known to 3 %. */
FACT(orourke12_fluctuations_become_alike)
{
    struct simulation *const sim =
        gas(1e-9, "collision_isotropy = {};", (double[3]){0, sqrt(3.0), 0});
    const double dt = 1e-4, rate = 96.0 / (5.0 * sqrt(M_PI)) * 0.2 * 1.5 / 1e-3;
    double sum, was, all = 0.0;
    const double before = square_sum(sim, 1, &was);

    for (int k = 0; k < 4; k++)
        ck_assert_int_eq(coupling_step(sim), 0);
    for (int k = 0; k < 3; k++)
        all += square_sum(sim, k, &sum);
    ck_assert_double_eq_tol(all / before, 1.0, 1e-12);
    const double more =
        square_sum(sim, 1, &sum) - 0.5 * (square_sum(sim, 0, &(double){0.0}) +
                                          square_sum(sim, 2, &(double){0.0}));
    ck_assert_double_eq_tol(sum, was, 1e-12 * GAS);
    ck_assert_double_eq_tol(more / before, pow(1.0 + rate * dt, -4.0), 0.06);
    build_free(sim);
}

/* Of the velocities and of the stress [J]: eps_s times the integral of
 * tau/eps_s^2 in a volume, -P eps_s ln(1 - eps_s/eps_cp). */
static double energy(const struct simulation *sim, struct hats *h, double P)
{
    const struct particles *const ps = sim->particles;
    double V[GAS], eps[64], sum, all = 0.0;

    for (int i = 0; i < ps->n; i++)
        V[i] = particles_volume(ps, i);
    hats_find(h, ps);
    hats_spread(h, 1, V, eps);
    for (int k = 0; k < 3; k++)
        all += 0.5 * ps->m[0] * square_sum(sim, k, &sum);
    for (int c = 0; c < sim->mesh->n_cells; c++)
        all -= P * sim->mesh->V[c] * eps[c] * log(1.0 - eps[c] / 0.6);
    return all;
}

/* Waves of 1 m/s, as fast as the particles. Both energies together fall by what
 * the implicit step takes of the noise, less than a thousandth here. */
FACT(snider01_a_closed_gas_gains_no_energy)
{
    const double P = 800.0;
    struct simulation *const sim = gas(P, "", (double[3]){1, 1, 1});
    struct hats *const h = hats_create(sim->mesh, GAS);
    const double first = energy(sim, h, P);
    double now = first, was, sum;

    square_sum(sim, 2, &was);
    for (int k = 0; k < 20; k++) {
        for (int i = 0; i < 10; i++)
            ck_assert_int_eq(coupling_step(sim), 0);
        now = energy(sim, h, P);
        ck_assert_double_le(now, first);
    }
    square_sum(sim, 2, &sum);
    ck_assert_double_ge(now, 0.999 * first);
    ck_assert_double_eq_tol(sum, was, 1e-12 * GAS);
    owner_free(h);
    build_free(sim);
}
