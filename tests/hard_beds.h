/* hard_beds.h -- cases that break a careless solver; for test_hard_beds.c and
 * figures/20/20-hard.c. */
#ifndef HARD_SCENES_H
#define HARD_SCENES_H

#include <stdio.h>

#include "case/build.h"
#include "case/case_file.h"

enum { HARD_MOST = 14 };

/* Half of the small bed, still moving a little when the case begins: settling
 * takes a quarter of the total time. */
#define HALF_BED                                                               \
    "mesh.size=[0.008,0.04,0.0015]", "particles.bed.count=150",                \
        "particles.bed.settle=0.08", "particles.step=2e-5"

struct hard {
    const char *name, *file;
    int steps;
    double fastest; /* [m/s] bound of the speed of every particle, with its
                       reason */
    int turned;     /* 1: gravity turns round when the bed has settled */
    int capped;     /* 1: cells are cut at a largest eps_s */
    const char *overrides[HARD_MOST];
};

static const struct hard hard_scenes[] = {
    /* K = 1e8 kg/(m^3 s) in every cell, dt/tau = 5000. They began with 0.35. */
    {"drag that stops at once",
     "cases/closed-box.cfg",
     100,
     0.4,
     0,
     0,
     {"fluid.viscosity=300", "exchange.slip_integration=exponential"}},
    /* A packed layer below the lid, clear liquid below it: it falls in fingers.
     * A single grain sinks with 0.16 m/s; a finger is several times as fast. */
    {"a dense plug above clear liquid",
     "cases/small-bed.cfg",
     200,
     1.0,
     1,
     0,
     {HALF_BED, "mesh.cells=[4,20,1]", "fluid.bottom=no-slip",
      "fluid.top=no-slip", "fluid.density=1000", "fluid.viscosity=1e-3",
      "particles.grains.density=2500", "effects.gravity=[0.0,9.81,0.0]",
      "effects.virtual_mass={}", "fluid.step=5e-4"}},
    /* An inlet of 1 m/s is switched on within one step, below a bed that it
     * lifts. */
    {"an inlet switched on at once",
     "cases/small-bed.cfg",
     100,
     1.5,
     0,
     0,
     {HALF_BED, "mesh.cells=[4,20,1]", "fluid.bottom.inlet=1.0"}},
    /* Diameters of 30:1 in a liquid that carries the small spheres with 0.1
     * m/s. */
    {"grains of 0.083 mm beside 2.5 mm",
     "cases/one-grain.cfg",
     60,
     0.3,
     0,
     0,
     {"exchange.slip_integration=exponential",
      "effects.gravity=[0.0,-9.81,0.0]", "effects.pressure_gradient={}",
      "effects.virtual_mass={}", "particles.grains.stiffness=5.0",
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
    /* Spheres of a tenth of the liquid's density, from rest to their rising
     * velocity, 0.25 m/s. */
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
     {HALF_BED, "mesh.cells=[9,45,1]", "averaging={method=\"pcm\";cap=0.7;}",
      "particles.bed.settle=0.05"}},
};
enum { HARD_SCENES = sizeof hard_scenes / sizeof *hard_scenes };

/* The case with this form of continuity; NULL if it cannot be built. */
static inline struct simulation *hard_build(const struct hard *h,
                                            const char *form)
{
    const char *list[HARD_MOST + 1];
    char continuity[40];
    int n = 0, code;

    snprintf(continuity, sizeof continuity, "fluid.continuity=%s", form);
    list[n++] = continuity;
    for (int i = 0; i < HARD_MOST && h->overrides[i] != NULL; i++)
        list[n++] = h->overrides[i];
    struct settings *const s = case_file_read(h->file, n, list, &code);
    if (s == NULL) return NULL;
    struct simulation *const sim = build_simulation(s, &code);
    settings_free(s);
    if (sim != NULL && h->turned) sim->gravity[1] = -sim->gravity[1];
    return sim;
}

#endif
