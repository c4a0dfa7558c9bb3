/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_dem [law] [threads] [copies] [falling] -- particle-steps a second in
 * the settled Mueller bed, 9240 spheres of 1.2 mm in 44 x 120 x 10 mm [SX15
 * Table 1], or in `copies` of it side by side in x. Not a test: run it on a
 * quiet machine.
 */
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "particles/bed.h"
#include "particles/limits.h"

/* Wall time, or processor time where the machine is not ours alone. */
static double now(void)
{
    struct timespec t;
    const int shared = getenv("BENCH_SHARED") != NULL;
    clock_gettime(shared ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void hold_weight(struct particles *ps)
{
    for (int i = 0; i < ps->n; i++)
        ps->ey[i] = -9.81 * ps->m[i];
}

static void time_steps(struct particles *ps, struct dem *dem, const char *what,
                       int steps)
{
    struct dem_report r = {0};
    double best = 0.0;

    hold_weight(ps);
    for (int segment = 0; segment < 5; segment++) {
        const double start = now();
        long rebuilds = 0;
        for (int k = 0; k < steps / 25; k++) {
            dem_run(dem, 25, &r);
            rebuilds += r.rebuilds;
        }
        const double rate = 1e-6 * ps->n * steps / (now() - start);
        best = rate > best ? rate : best;
        printf("%s: %6.2f M/s  rebuilds %ld  contacts %d  v %.3g m/s\n", what,
               rate, rebuilds, r.contacts, r.max_speed);
    }
    printf("%s, best: %.2f M particle-steps/s\n", what, best);
}

static const struct bed_options bed = {.count = 9240,
                                       .diameter = 1.2e-3,
                                       .density = 1000.0,
                                       .seed = 1,
                                       .jitter = 0.5,
                                       .gravity = {0.0, -9.81, 0.0},
                                       .settle = 1.0};

static struct dem_options mueller(const char *law, int copies)
{
    const struct dem_options o = {.law = contact_law_named(law),
                                  .material = {.young = 1.2e5,
                                               .poisson = 0.33,
                                               .stiffness = 100.0,
                                               .restitution = 0.98,
                                               .friction = 0.1},
                                  .step = 4e-6,
                                  .skin = 0.2e-3,
                                  .hi = {0.044 * copies, 0.12, 0.01}};
    return o;
}

static void falling(const char *law)
{
    const struct dem_options o = mueller(law, 1);
    struct particles *const ps = particles_create(bed.count);
    struct dem *const dem = dem_create(ps, &o);

    bed_fill(ps, &bed, &o);
    time_steps(ps, dem, "falling", 2000);
    dem_free(dem);
    particles_free(ps);
}

/* The settled bed, from its file if it was made before. */
static struct particles *settled(const char *law)
{
    const struct dem_options o = mueller(law, 1);
    struct particles *const ps = particles_create(bed.count);
    struct dem *const dem = dem_create(ps, &o);
    struct bed_report r;
    char path[64];

    snprintf(path, sizeof path, "/tmp/bench-dem-%s.bed", law);
    const double start = now();
    bed_make(path, ps, dem, &bed, &o, &r);
    printf("%s: settled %d in %.3g s (%ld steps), %.2f s; kinetic %.3g; height "
           "%.4g, top %.4g m, packing %.3f\n",
           law, r.settled, r.time, r.steps, now() - start, r.kinetic, r.height,
           r.top, r.packing);
    dem_free(dem);
    return ps;
}

/* Beds side by side, without the walls between. */
static struct particles *tiled(const struct particles *one, int copies)
{
    struct particles *const ps = particles_create(one->n * copies);

    for (int c = 0; c < copies; c++)
        for (int i = 0; i < one->n; i++)
            particles_add(
                ps,
                (const double[3]){one->x[i] + 0.044 * c, one->y[i], one->z[i]},
                one->d[i], 1000.0);
    return ps;
}

int main(int argc, char **argv)
{
    const char *const law = argc > 1 ? argv[1] : "hertz";
    const int copies = argc > 3 ? atoi(argv[3]) : 1;

    if (argc > 2) omp_set_num_threads(atoi(argv[2]));
    if (argc > 4) falling(law);
    struct particles *const one = settled(law);
    struct particles *const ps = tiled(one, copies);
    const struct dem_options o = mueller(law, copies);
    struct dem *const dem = dem_create(ps, &o);
    time_steps(ps, dem, "settled", copies > 4 ? 100 : 2000);
    dem_free(dem);
    particles_free(ps);
    particles_free(one);
    return 0;
}
