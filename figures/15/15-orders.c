/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 15-orders.c -- the error of each integrator against the steps of a contact.
 *
 * Two spheres that overlap push each other apart, law "linear": the overlap is
 * a damped oscillator, known exactly. Printed is its error after 1.2 / w over
 * its start, for e = 1 and e = 0.5; then the energy of a sphere that swings
 * between two walls, 25 steps a period.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "dem/contact_linear.h"
#include "dem/dem.h"
#include "dem/energy.h"

static const double k_n = 1e4, overlap = 1e-4, d = 0.01; /* [N/m], [m], [m] */

static struct dem_options options(const struct integrator *by, double e)
{
    const struct dem_options o = {
        .law = &contact_linear,
        .integrator = by,
        .material = {.stiffness = k_n, .restitution = e},
        .lo = {-0.1, -0.1, -0.1},
        .hi = {0.1, 0.1, 0.1}};
    return o;
}

static double error(const struct integrator *by, double e, int steps)
{
    struct particles *const ps = particles_create(2);
    struct dem_options o = options(by, e);
    struct dem_report r;

    particles_add(ps, (double[3]){-0.5 * (d - overlap), 0, 0}, d, 2000.0);
    particles_add(ps, (double[3]){0.5 * (d - overlap), 0, 0}, d, 2000.0);
    const double w = sqrt(2.0 * k_n / ps->m[0]);
    const double zeta = contact_damping_ratio(e);
    const double w_d = w * sqrt(1.0 - zeta * zeta), T = 1.2 / w;
    o.step = T / steps;
    struct dem *const dem = dem_create(ps, &o);
    dem_run(dem, steps, &r);
    const double exact = overlap * exp(-zeta * w * T) *
                         (cos(w_d * T) + zeta * w / w_d * sin(w_d * T));
    const double found = d - fabs(ps->x[1] - ps->x[0]);
    dem_free(dem);
    particles_free(ps);
    return fabs(found - exact) / overlap;
}

/* Energy of the swing over its start, after so many periods. */
static double energy(const struct integrator *by, int periods)
{
    struct particles *const ps = particles_create(1);
    struct dem_options o = options(by, 1.0);
    struct dem_report r;

    o.lo[0] = -0.49 * d;
    o.hi[0] = 0.49 * d;
    particles_add(ps, (double[3]){0, 0, 0}, d, 2000.0);
    ps->vx[0] = 0.01;
    o.step = 2.0 * M_PI / sqrt(2.0 * k_n / ps->m[0]) / 25.0;
    struct dem *const dem = dem_create(ps, &o);
    dem_start_energy_budget(dem);
    dem_run(dem, 25 * periods, &r);
    const struct energy *const b = dem_energy(dem);
    const double rest = k_n * gsl_pow_2(0.01 * d);
    const double found =
        (b->kinetic + b->normal - rest) / (0.5 * ps->m[0] * 1e-4);
    dem_free(dem);
    particles_free(ps);
    return found;
}

int main(void)
{
    static const double e[2] = {1.0, 0.5};

    for (int c = 0; c < 2; c++) {
        printf("## e = %g\n# steps a contact, error of: verlet, euler, heun\n",
               e[c]);
        for (int n = 4; n <= 256; n *= 2) {
            printf("%.1f", n * M_PI / 1.2);
            for (int i = 0; i < 3; i++)
                printf(" %.3e", error(integrators[i], e[c], n));
            printf("\n");
        }
        printf("\n\n");
    }
    puts("## energy\n# periods, energy over its start: verlet, euler, heun");
    for (int p = 0; p <= 200; p += 10) {
        printf("%d", p);
        for (int i = 0; i < 3; i++)
            printf(" %.5f", energy(integrators[i], p));
        printf("\n");
    }
    return 0;
}
