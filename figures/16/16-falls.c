/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 16-falls.c -- spheres that fall and slip, after the cases of MFiX [Garg12].
 *
 *   bounces   DEM02: the tops of five bounces, ours and a hard sphere's
 *   rolling   DEM04: when a slipping sphere rolls, and how fast
 *   energy    1000 elastic spheres in a box, over a million steps
 */
#include <gsl/gsl_math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dem/contact_linear.h"
#include "dem/dem.h"

static const double g = 9.81; /* [m/s^2] */

/* d = 0.2 m, 2600 kg/m^3, centre 0.5 m above the floor. */
static void bounces(double k, double e)
{
    const double r = 0.1, h = 0.5;
    struct particles *const ps = particles_create(1);
    struct dem_options o = {
        .law = &contact_linear, .lo = {-1.0, 0.0, -1.0}, .hi = {1.0, 2.0, 1.0}};
    struct dem_report report;
    double v = -1.0, hard = h - r;

    particles_add(ps, (double[3]){0.0, h, 0.0}, 2.0 * r, 2600.0);
    ps->ey[0] = -g * ps->m[0];
    o.material.stiffness = k;
    o.material.restitution = e;
    o.step = 2e-3 * contact_linear_time(k, e, ps->m[0]);
    struct dem *const dem = dem_create(ps, &o);
    printf("0 %.5f %.5f\n", h, h);
    for (int tops = 0; tops < 5;) {
        if (dem_run(dem, 1, &report) != 0) exit(1);
        if (v > 0.0 && ps->vy[0] <= 0.0) {
            hard *= e * e;
            printf("%d %.5f %.5f\n", ++tops, ps->y[0], r + hard);
        }
        v = ps->vy[0];
    }
    dem_free(dem);
    particles_free(ps);
}

static void all_bounces(void)
{
    static const double k[] = {5e4, 5e5, 5e6};

    for (int i = 0; i < 3; i++) {
        printf("%s# k = %g N/m, e = 0.9: bounce, top [m], of a hard sphere\n",
               i > 0 ? "\n\n" : "", k[i]);
        bounces(k[i], 0.9);
    }
}

/* d = 1 mm, 10^4 kg/m^3, slips at 0.1 m/s, pressed to the floor by its weight.
 */
static void rolling(void)
{
    const double u0 = 0.1, r = 5e-4, step = 2e-6;

    printf("# mu, t mu g/u0 when it rolls (2/7), u/u0 (5/7)\n");
    for (int i = 1; i <= 5; i++) {
        struct particles *const ps = particles_create(1);
        struct dem_options o = {.law = &contact_linear,
                                .material = {.stiffness = 1e4,
                                             .restitution = 1.0,
                                             .friction = 0.2 * i},
                                .step = step,
                                .lo = {-1.0, 0.0, -1.0},
                                .hi = {1.0, 1.0, 1.0}};
        struct dem_report report;
        long steps = 0;

        particles_add(ps, (double[3]){0.0, r, 0.0}, 2.0 * r, 1e4);
        ps->ey[0] = -g * ps->m[0];
        ps->y[0] -= g * ps->m[0] / 1e4;
        ps->vx[0] = u0;
        struct dem *const dem = dem_create(ps, &o);
        while (ps->vx[0] + r * ps->wz[0] > 1e-4 * u0) {
            if (dem_run(dem, 1, &report) != 0) exit(1);
            steps++;
        }
        printf("%.1f %.5f %.5f\n", 0.2 * i,
               (double)steps * step * 0.2 * i * g / u0, ps->vx[0] / u0);
        dem_free(dem);
        particles_free(ps);
    }
}

/* 10^3 spheres of 1 mm, an eighth of the box, thrown at up to 0.1 m/s. */
static struct particles *gas(void)
{
    struct particles *const ps = particles_create(1000);
    unsigned long state = 1;

    for (int i = 0; i < 1000; i++) {
        double *const v[3] = {&ps->vx[i], &ps->vy[i], &ps->vz[i]};
        const double x[3] = {1.6e-3 * (i % 10 + 0.5),
                             1.6e-3 * (i / 10 % 10 + 0.5),
                             1.6e-3 * (i / 100 + 0.5)};
        particles_add(ps, x, 1e-3, 2000.0);
        for (int k = 0; k < 3; k++) {
            state = (state * 1103515245UL + 12345UL) % 2147483648UL;
            *v[k] = 0.1 * ((double)state / 1073741824.0 - 1.0);
        }
    }
    return ps;
}

/* The kinetic energy, as the mean of many samples: a few springs are compressed
 * at each of them. */
static void energy(void)
{
    struct particles *const ps = gas();
    const struct dem_options o = {
        .law = &contact_linear,
        .material = {.stiffness = 1000.0, .restitution = 1.0},
        .step = 2e-6,
        .hi = {16e-3, 16e-3, 16e-3}};
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;
    double first = 0.0;

    if (dem_run(dem, 0, &r) != 0) exit(1);
    first = r.translation;
    printf(
        "# step, mean of 200 samples of the kinetic energy over the first\n");
    for (int k = 1; k <= 10; k++) {
        double sum = 0.0;
        for (int sample = 0; sample < 200; sample++) {
            if (dem_run(dem, 500, &r) != 0) exit(1);
            sum += r.translation;
        }
        printf("%d %.6f\n", 100000 * k, sum / 200.0 / first);
    }
    dem_free(dem);
    particles_free(ps);
}

int main(int argc, char **argv)
{
    const char *const what = argc > 1 ? argv[1] : "";

    if (strcmp(what, "bounces") == 0)
        all_bounces();
    else if (strcmp(what, "rolling") == 0)
        rolling();
    else
        energy();
    return 0;
}
