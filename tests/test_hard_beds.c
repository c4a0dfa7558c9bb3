/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cases that break a careless solver, in both forms of continuity. None is
 * accurate at these steps; all must stay finite and bounded, and balance. */
#include "coupling/coupling.h"

#include "facts.h"
#include "hard_beds.h"
#include "suspension.h"

/* A periodic box without weight: nothing comes from outside, and momentum stays
 * to 1e-9, since 5000 times as much is exchanged back and forth in the first
 * case. */
static int closed(const struct simulation *sim)
{
    return sim->mesh->n_faces == sim->mesh->n_internal &&
           sim->gravity[1] == 0.0;
}

/* Continuity to some times the solver's 1e-6; the impulse on the fluid is the
 * opposite of that on the particles, to rounding (sums of some thousand terms),
 * also where a cap leaves part of the spheres out of eps_s. */
FACT_FOR_EACH(hard_cases_stay_finite_bounded_and_balanced, 2 * HARD_SCENES)
{
    const struct hard *const h = &hard_scenes[_i / 2];
    struct simulation *const sim =
        hard_build(h, _i % 2 ? "mixture" : "void-rate");
    double before[3], after[3];
    int capped = 0;

    ck_assert_msg(sim != NULL, "%s", h->name);

    ck_assert_int_eq(coupling_start(sim), 0);
    coupling_total_momentum(sim, before);
    for (int i = 0; i < h->steps; i++) {
        ck_assert_msg(coupling_step(sim) == 0, "%s: step %d", h->name, i);
        ck_assert_msg(sim->dem_report.max_speed < h->fastest,
                      "%s: %g m/s in step %d", h->name,
                      sim->dem_report.max_speed, i);
        ck_assert_double_lt(sim->fluid->report.mass_residual, 1e-5);
        ck_assert_double_lt(sim->coupling->report.exchange_residual, 1e-9);
        capped |= averaging_report(sim->averaging)->capped > 0;
    }
    ck_assert_int_eq(capped, h->capped);
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3 && closed(sim); k++)
        ck_assert_double_lt(
            fabs(after[k] - before[k] - sim->fluid->relabelled[k]),
            1e-9 * fabs(before[0]));
    for (int c = 0; c < sim->mesh->n_cells; c++)
        ck_assert(sim->fluid->eps[c] > 0.29 && sim->fluid->eps[c] <= 1.0);
    build_free(sim);
}

/* Three layers of cells, each full of one sphere, beside three empty ones; all
 * change cells in the same step, again and again. Momentum to rounding. */
FACT_FOR_EACH(full_cells_become_empty_ones_in_one_step, 2)
{
    struct scene s = air;
    double before[3], after[3];
    s.averaging = "pcm";
    s.n = 3 * s.cells * s.cells;
    s.d = 1.9e-3;
    s.continuity = _i ? CONTINUITY_MIXTURE : CONTINUITY_VOID_RATE;
    struct simulation *const sim = build(&s);
    struct particles *const ps = sim->particles;

    for (int i = 0; i < s.n; i++) {
        const int c = ps->id[i];
        ps->x[i] = sim->mesh->centre[3 * c];
        ps->y[i] = sim->mesh->centre[3 * c + 1];
        ps->z[i] = sim->mesh->centre[3 * c + 2];
        ps->vx[i] = ps->vy[i] = 0.0;
        ps->vz[i] = 0.4;
    }
    dem_changed(sim->dem);
    ck_assert_int_eq(coupling_start(sim), 0);
    coupling_total_momentum(sim, before);
    run(sim, 150); /* 12 mm: once round the box */
    coupling_total_momentum(sim, after);
    for (int k = 0; k < 3; k++)
        ck_assert_double_lt(
            fabs(after[k] - before[k] - sim->fluid->relabelled[k]),
            1e-12 * gross_momentum(sim));
    ck_assert_double_lt(sim->dem_report.max_speed, 0.5);
    discard(sim);
}

FACTS
{
    tcase_set_timeout(facts, 120.0);
}
