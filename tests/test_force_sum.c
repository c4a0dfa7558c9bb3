/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All forces of the fluid on a particle at once [LS 5.8, EW18 12]. */
#include "coupling/coupling.h"

#include <omp.h>

#include "facts.h"
#include "suspension.h"

/* A liquid with spheres from a tenth of its density on, all that spin. */
static struct scene all_on(double ratio)
{
    struct scene s = air;

    s.rho = 1000.0;
    s.mu = 1e-3;
    s.rho_s = ratio * s.rho;
    s.virtual_mass = 0.5;
    s.viscous_stress = s.saffman = s.magnus = s.fluid_torque = 1;
    s.basset = 2e-3;
    s.roughness = 1e-6;
    return s;
}

static void spin(struct simulation *sim)
{
    struct particles *const ps = sim->particles;

    for (int i = 0; i < ps->n; i++) {
        ps->wx[i] = 200.0 * ps->vy[i];
        ps->wy[i] = 100.0 * ps->vz[i];
        ps->wz[i] = 300.0 * ps->vx[i];
    }
}

static const double ratios[] = {10.0, 2.65, 1.0, 0.1};

/* Every force of [LS 5.8] on, in a closed periodic box: what the particles gain
 * the fluid loses, in 4 densities x 2 treatments x 2 integrations of the slip x
 * both forms of the momentum equation. 1e-12: as in test_coupling. */
FACT_FOR_EACH(ls_5_8_the_sum_of_all_forces_keeps_total_momentum, 32)
{
    struct scene s = all_on(ratios[_i % 4]);
    double before[3], after[3];
    s.treatment = _i / 4 % 2 ? TREATMENT_EXPLICIT : TREATMENT_SEMI_IMPLICIT;
    s.relaxation =
        _i / 8 % 2 ? SLIP_INTEGRATION_EXPONENTIAL : SLIP_INTEGRATION_FROZEN;
    s.model_b = _i / 16 % 2;
    struct simulation *const sim = build(&s);
    spin(sim);
    coupling_total_momentum(sim, before);
    const double scale = gross_momentum(sim) + fabs(before[0]);
    run(sim, 10);
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_lt(
            fabs(after[k] - before[k] - sim->fluid->relabelled[k]),
            1e-12 * scale);
    for (int i = 0; i < s.n; i++) /* bounded by the initial velocities */
        ck_assert_double_lt(fabs(sim->particles->vx[i]), 0.6);
    for (int e = 0; e < sim->n_effects; e++) /* each of them did something */
        ck_assert(sim->effects[e].effect->before_particles == NULL ||
                  sim->effects[e].tally.sum > 0.0 ||
                  sim->effects[e].effect == effect_named("fluid_torque"));
    discard(sim);
}

/* The order of all sums is fixed; the particles are told apart by their ids. */
FACT(ls_5_8_one_thread_and_two_give_the_same_bits)
{
    double v[2] = {0.0, 0.0};

    for (int threads = 1; threads <= 2; threads++) {
        struct scene s = all_on(2.65);
        omp_set_num_threads(threads);
        struct simulation *const sim = build(&s);
        spin(sim);
        run(sim, 20);
        for (int i = 0; i < s.n; i++)
            v[threads - 1] += (1 + sim->particles->id[i]) *
                              (sim->particles->vx[i] + sim->particles->vy[i]);
        discard(sim);
    }
    ck_assert_double_eq(v[0], v[1]);
}
