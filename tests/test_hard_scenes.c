/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenes that break a careless solver, in both forms of continuity. None is
 * accurate at these steps; all must stay finite and bounded, and balance. */
#include "exchange/coupling.h"

#include "scene/build.h"
#include "scene/scene.h"
#include "suspension.h"

enum { MOST = 9 };

struct hard {
    const char *name, *file;
    int steps;
    double fastest; /* [m/s] bound of every particle, with its reason */
    int turned;     /* 1: gravity turns round when the bed has settled */
    int capped;     /* 1: cells are cut at a largest eps_s */
    const char *overrides[MOST];
};

static const struct hard cases[] = {
    /* K = 1e8 kg/(m^3 s) in every cell, dt/tau = 5000. They began with 0.35. */
    {"drag that stops at once",
     "cases/closed-box.cfg",
     100,
     0.4,
     0,
     0,
     {"fluid.viscosity=300", "exchange.relaxation=exponential"}},
    /* A packed layer below the lid, clear liquid below it: it falls, in
     * fingers. One grain alone sinks with 0.16 m/s; a finger is some times as
     * fast. */
    {"a dense plug above clear liquid",
     "cases/small-bed.cfg",
     200,
     1.0,
     1,
     0,
     {"fluid.bottom=no-slip", "fluid.top=no-slip", "fluid.density=1000",
      "fluid.viscosity=1e-3", "particles.grains.density=2500",
      "effects.gravity=[0.0,9.81,0.0]", "effects.virtual_mass={}",
      "fluid.step=5e-4"}},
    /* 1 m/s from one step to the next, below a bed that it lifts. */
    {"an inlet switched on at once",
     "cases/small-bed.cfg",
     100,
     1.5,
     0,
     0,
     {"fluid.bottom.inlet=1.0"}},
    /* 30:1 in a liquid that pushes the small ones along with 0.1 m/s. */
    {"grains of 0.083 mm beside 2.5 mm",
     "cases/one-grain.cfg",
     60,
     0.3,
     0,
     0,
     {"exchange.relaxation=exponential", "effects.gravity=[0.0,-9.81,0.0]",
      "effects.pressure_gradient={}", "effects.virtual_mass={}",
      "particles.grains.stiffness=5.0",
      "averaging={method=\"diffusion\";bandwidth=4e-3;}",
      "particles.place=("
      "{position=[0.003,0.010,0.003];diameter=2.5e-3;},"
      "{position=[0.003,0.0115,0.003];diameter=8.3e-5;},"
      "{position=[0.0045,0.010,0.003];diameter=8.3e-5;},"
      "{position=[0.003,0.0085,0.003];diameter=8.3e-5;},"
      "{position=[0.0031,0.0084,0.0031];diameter=8.3e-5;})"}},
    {"a single cell",
     "cases/closed-box.cfg",
     100,
     0.4,
     0,
     0,
     {"mesh.cells=[1,1,1]", "averaging={method=\"pcm\";}"}},
    /* A tenth as heavy as the liquid, from rest to its rise, 0.25 m/s. */
    {"light spheres rise",
     "cases/closed-box.cfg",
     100,
     1.0,
     0,
     0,
     {"particles.grains.density=10", "effects.gravity=[0.0,-9.81,0.0]",
      "effects.pressure_gradient={}", "effects.virtual_mass={}"}},
    /* Cells smaller than a sphere: eps_f is cut off at 0.3. */
    {"cells with 0.3 of fluid",
     "cases/small-bed.cfg",
     100,
     1.5,
     0,
     1,
     {"mesh.cells=[16,64,1]", "averaging={method=\"pcm\";cap=0.7;}"}},
};
enum { CASES = sizeof cases / sizeof *cases };

static struct simulation *prepare(const struct hard *h, const char *form)
{
    const char *list[MOST + 1];
    char continuity[40];
    int n = 0, code;

    snprintf(continuity, sizeof continuity, "fluid.continuity=%s", form);
    list[n++] = continuity;
    for (int i = 0; i < MOST && h->overrides[i] != NULL; i++)
        list[n++] = h->overrides[i];
    struct settings *const s = scene_read(h->file, n, list, &code);
    ck_assert_msg(s != NULL, "%s", h->name);
    struct simulation *const sim = build_simulation(s, &code);
    ck_assert_msg(sim != NULL, "%s", h->name);
    settings_free(s);
    if (h->turned) sim->gravity[1] = -sim->gravity[1];
    return sim;
}

/* Continuity to the solver's 1e-6; what the fluid paid is what the particles
 * were charged, to rounding (sums of some thousand terms); but where a cap cuts
 * what a particle gives to its cell, it does not cut what it takes from it: a
 * part in a thousand, as reported. */
START_TEST(hard_scenes_stay_finite_bounded_and_balanced)
{
    const struct hard *const h = &cases[_i / 2];
    struct simulation *const sim = prepare(h, _i % 2 ? "mixture" : "void-rate");

    ck_assert_int_eq(coupling_start(sim), 0);
    for (int i = 0; i < h->steps; i++) {
        ck_assert_msg(coupling_step(sim) == 0, "%s: step %d", h->name, i);
        ck_assert_msg(sim->dem_report.max_speed < h->fastest,
                      "%s: %g m/s in step %d", h->name,
                      sim->dem_report.max_speed, i);
        ck_assert_double_lt(sim->fluid->report.mass_residual, 1e-6);
        ck_assert_double_lt(sim->coupling->report.exchange_residual,
                            h->capped ? 1e-2 : 1e-9);
    }
    for (int c = 0; c < sim->mesh->n_cells; c++)
        ck_assert(sim->fluid->eps[c] > 0.29 && sim->fluid->eps[c] <= 1.0);
    build_free(sim);
}
END_TEST

/* Three layers of cells, each full of one sphere, beside three empty ones; all
 * change cells in the same step, again and again. Momentum to rounding. */
START_TEST(full_cells_become_empty_ones_in_one_step)
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
END_TEST

int main(void)
{
    Suite *const s = suite_create("hard scenes");
    TCase *const t = tcase_create("hard scenes");

    suite_add_tcase(s, t);
    tcase_set_timeout(t, 120.0);
    tcase_add_loop_test(t, hard_scenes_stay_finite_bounded_and_balanced, 0,
                        2 * CASES);
    tcase_add_loop_test(t, full_cells_become_empty_ones_in_one_step, 0, 2);
    SRunner *const r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    const int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
