/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 15-lists.c -- what a step of a particle costs, by the way pairs are found.
 *
 * A box full of spheres that fly about like a dense gas (solid fraction 0.35,
 * up to 1 d in 1000 steps, so that lists wear out as in a fluidized
 * bed): microseconds of processor time a particle and step, the best of three,
 * for skins from d/50 to d, and with link cells by the reference loop; then for
 * 500 to 64000 spheres, and for a few with all pairs.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <time.h>

#include "dem/contact_hertz.h"
#include "dem/dem.h"
#include "dem/reference.h"

static const double d = 1e-3, pitch = 1.12e-3; /* [m] */
enum { STEPS = 300 };

static double chance(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 4503599627370496.0 - 1.0;
}

/* n^3 spheres, to 1 m/s in each direction. */
static struct particles *gas(int n)
{
    struct particles *const ps = particles_create(n * n * n);
    uint64_t seed = 5;

    for (int k = 0; k < n * n * n; k++) {
        const double at[3] = {k % n, k / n % n, k / n / n};
        double x[3];
        for (int a = 0; a < 3; a++)
            x[a] = (at[a] + 0.5) * pitch + 0.05e-3 * chance(&seed);
        const int i = particles_add(ps, x, d, 2000.0);
        ps->vx[i] = 1.0 * chance(&seed);
        ps->vy[i] = 1.0 * chance(&seed);
        ps->vz[i] = 1.0 * chance(&seed);
    }
    return ps;
}

/* [us] a particle and step, after as many steps to warm up; method NULL: the
 * list, with this skin. */
static double cost(int n, double skin, const struct dem_method *method)
{
    const double L = n * pitch;
    const struct dem_options o = {.law = &contact_hertz,
                                  .material = {.young = 1e7,
                                               .poisson = 0.25,
                                               .restitution = 0.95,
                                               .friction = 0.2},
                                  .step = 1e-6,
                                  .skin = skin,
                                  .method = method,
                                  .hi = {L, L, L}};
    struct particles *const ps = gas(n);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;
    double best = HUGE_VAL;

    dem_run(dem, STEPS, &r);
    for (int k = 0; k < 3; k++) {
        const clock_t before = clock();
        dem_run(dem, STEPS, &r);
        best = fmin(best, (double)(clock() - before) / CLOCKS_PER_SEC);
    }
    const double us = 1e6 * best / STEPS / ps->n;
    dem_free(dem);
    particles_free(ps);
    return us;
}

int main(void)
{
    static const double part[] = {0.02, 0.05, 0.1, 0.15, 0.2,
                                  0.3,  0.4,  0.6, 0.8,  1.0};
    static const int side[] = {8, 12, 18, 27, 40};

    puts("## skin\n# skin over d, us a particle and step: list; link cells");
    const double cells = cost(20, 0.0, &reference_link_cells);
    for (int k = 0; k < 10; k++)
        printf("%.2f %.4f %.4f\n", part[k], cost(20, part[k] * d, NULL), cells);
    puts("\n\n## number\n# particles, us: list with d/6, link cells");
    for (int k = 0; k < 5; k++)
        printf("%d %.4f %.4f\n", side[k] * side[k] * side[k],
               cost(side[k], d / 6.0, NULL),
               cost(side[k], 0.0, &reference_link_cells));
    puts("\n\n## pairs\n# particles, us: all pairs");
    for (int k = 0; k < 2; k++)
        printf("%d %.4f\n", side[k] * side[k] * side[k],
               cost(side[k], 0.0, &reference_all_pairs));
    return 0;
}
