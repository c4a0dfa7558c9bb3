/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bench_dem [law] [threads] [copies] -- particle-steps a second in the settled
 * Mueller bed, 9240 spheres of 1.2 mm in 44 x 120 x 10 mm [SX15 Table 1], or
 * in `copies` of it side by side in x. Not a test: run it on a quiet machine.
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

int main(int argc, char **argv)
{
    const char *const name = argc > 1 ? argv[1] : "hertz";
    const int copies = argc > 3 ? atoi(argv[3]) : 1;
    const struct bed_options bed = {.count = 9240 * copies,
                                    .diameter = 1.2e-3,
                                    .density = 1000.0,
                                    .seed = 1,
                                    .jitter = 0.5,
                                    .gravity = {0.0, -9.81, 0.0},
                                    .settle = 1.0};
    const struct dem_options o = {.law = contact_law_named(name),
                                  .material = {.young = 1.2e5,
                                               .poisson = 0.33,
                                               .stiffness = 100.0,
                                               .restitution = 0.98,
                                               .friction = 0.1},
                                  .step = 4e-6,
                                  .skin = 0.2e-3,
                                  .hi = {0.044 * copies, 0.12, 0.01}};
    struct particles *const ps = particles_create(bed.count);
    struct bed_report r;

    if (argc > 2) omp_set_num_threads(atoi(argv[2]));
    struct dem *dem = dem_create(ps, &o);
    bed_fill(ps, &bed, &o);
    if (copies == 1) time_steps(ps, dem, "falling", 2000);
    dem_free(dem);
    ps->n = 0;
    dem = dem_create(ps, &o);
    const double start = now();
    bed_make(NULL, ps, dem, &bed, &o, &r);
    printf("%s: settled %d in %.3g s (%ld steps), %.2f s of wall time; "
           "kinetic %.3g; height %.4g, top %.4g m, packing %.3f\n",
           name, r.settled, r.time, r.steps, now() - start, r.kinetic, r.height,
           r.top, r.packing);
    time_steps(ps, dem, "settled", copies > 4 ? 200 : 2000);
    dem_free(dem);
    particles_free(ps);
    return 0;
}
