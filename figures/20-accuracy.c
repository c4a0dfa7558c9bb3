/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 20-accuracy.c -- what accuracy costs in a short bed: cases/small-bed.cfg with
 * other steps, treatments and averages, SEEDS beds each.
 *
 * One line a variant: processor seconds of a run; mean height of the grains
 * [mm] and pressure drop over the weight [-] over the second half of 0.6 s,
 * each with the statistical error of the mean over the beds.
 */
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <time.h>

#include "coupling/coupling.h"
#include "case/build.h"
#include "case/history_sums.h"
#include "case/case_file.h"

enum { SEEDS = 6, MOST = 2 };

static const struct variant {
    const char *name, *overrides[MOST];
} variants[] = {
    {"as the case has it", {NULL}},
    {"fluid step 5e-5 s", {"fluid.step=5e-5"}},
    {"fluid step 1e-4 s", {"fluid.step=1e-4"}},
    {"fluid step 5e-4 s", {"fluid.step=5e-4"}},
    {"fluid step 1e-3 s", {"fluid.step=1e-3"}},
    {"fluid step 2e-3 s", {"fluid.step=2e-3"}},
    {"particle step 5e-6 s", {"particles.step=5e-6"}},
    {"particle step 2e-5 s", {"particles.step=2e-5"}},
    {"explicit", {"exchange.treatment=explicit"}},
    {"exponential", {"exchange.slip_integration=exponential"}},
    {"4 sub-steps", {"exchange.substeps=4"}},
    {"bell, 4.8 mm", {"averaging.method=kernel"}},
    {"diffusion, 2.4 mm", {"averaging.bandwidth=2.4e-3"}},
    {"diffusion, 9.6 mm", {"averaging.bandwidth=9.6e-3"}},
    {"sums of each cell", {"averaging={method=\"pcm\";}"}},
};

struct outcome {
    double seconds, height, drop; /* [s] of the processor, [m], [-] */
};

static double mean_height(const struct particles *ps)
{
    double sum = 0.0;

    for (int i = 0; i < ps->n; i++)
        sum += ps->y[i];
    return sum / ps->n;
}

/* Zero after a run that went through. */
static int run(const struct variant *v, int seed, struct outcome *r)
{
    const char *list[MOST + 1];
    char text[40];
    int n = 0, code, failed;

    snprintf(text, sizeof text, "particles.bed.seed=%d", seed);
    list[n++] = text;
    for (int i = 0; i < MOST && v->overrides[i] != NULL; i++)
        list[n++] = v->overrides[i];
    struct settings *const s =
        case_file_read("cases/small-bed.cfg", n, list, &code);
    if (s == NULL) return 1;
    struct simulation *const sim = build_simulation(s, &code);
    settings_free(s);
    if (sim == NULL) return 1;
    const clock_t start = clock();
    const long steps = lround(0.6 / sim->dt);
    *r = (struct outcome){0};
    failed = coupling_start(sim);
    for (long k = 0; k < steps && !failed; k++) {
        failed = coupling_step(sim);
        if (2 * k < steps) continue;
        r->height += mean_height(sim->particles) / (0.5 * (double)steps);
        r->drop += history_pressure_drop(sim) / history_bed_weight(sim) /
                   (0.5 * (double)steps);
    }
    r->seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    build_free(sim);
    return failed;
}

static void report(const struct variant *v)
{
    double seconds = 0.0, height = 0.0, drop = 0.0, h2 = 0.0, d2 = 0.0;

    for (int seed = 1; seed <= SEEDS; seed++) {
        struct outcome r;
        if (run(v, seed, &r) != 0) {
            printf("%-22s breaks down with seed %d\n", v->name, seed);
            return;
        }
        seconds += r.seconds / SEEDS;
        height += r.height / SEEDS;
        drop += r.drop / SEEDS;
        h2 += gsl_pow_2(r.height) / SEEDS;
        d2 += gsl_pow_2(r.drop) / SEEDS;
    }
    printf("%-22s %6.2f  %6.2f %5.2f  %6.3f %6.3f\n", v->name, seconds,
           1e3 * height, 1e3 * sqrt((h2 - height * height) / (SEEDS - 1)), drop,
           sqrt((d2 - drop * drop) / (SEEDS - 1)));
    fflush(stdout);
}

int main(void)
{
    if (freopen("/dev/null", "w", stderr) == NULL) return 4;
    printf("# variant, processor [s], height and its error [mm], drop over "
           "weight and its error [-]\n");
    for (unsigned i = 0; i < sizeof variants / sizeof *variants; i++)
        report(&variants[i]);
    return 0;
}
