/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 14-seam.c -- a sphere rolls over the seam of two triangles in one plane.
 *
 * Prints where it is, the force of the floor over its weight and its velocity,
 * 1 mm at a time; then the largest force of all steps.
 */
#include <math.h>
#include <stdio.h>

#include "dem/surfaces/surface.h"
#include "dem/contact_hertz.h"
#include "dem/dem.h"

static const double g = 9.81; /* [m/s^2] */

int main(void)
{
    double corner[2][3][3] = {{{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}},
                              {{0, 0, -1}, {1, 0, 0}, {0, 0, 1}}};
    const struct surface floor = {.name = "floor",
                                  .shape = &surface_stl,
                                  .triangles = triangles_create(2, corner)};
    const struct dem_options o = {.law = &contact_hertz,
                                  .material = {.young = 5e6,
                                               .poisson = 0.45,
                                               .restitution = 0.3,
                                               .friction = 0.5},
                                  .step = 1e-5,
                                  .lo = {-1, -1, -1},
                                  .hi = {1, 1, 1},
                                  .surfaces = &floor,
                                  .n_surfaces = 1};
    struct particles *const ps = particles_create(1);
    struct dem_report r;
    double next = -3e-4, most = 0.0;

    particles_add(ps, (const double[]){-0.02, 2.498e-3, 0.0}, 5e-3, 2500.0);
    ps->vx[0] = 0.1;
    ps->wz[0] = -0.1 / 2.5e-3;
    ps->ey[0] = -g * ps->m[0];
    struct dem *const dem = dem_create(ps, &o);
    printf("# x [m]  force over weight [-]  velocity [m/s]\n");
    while (ps->x[0] < 1.2e-3) {
        dem_run(dem, 1, &r);
        const double force = ps->cfy[0] / (g * ps->m[0]);
        if (ps->x[0] > -3e-4) most = fmax(most, force);
        if (ps->x[0] < next) continue;
        printf("%.5f %.5f %.5f\n", ps->x[0], force, ps->vx[0]);
        next += 1e-5;
    }
    printf("largest_force = %.4f\n", most);
    printf("velocity_left = %.4f\n", ps->vx[0]);
    dem_free(dem);
    particles_free(ps);
    return 0;
}
