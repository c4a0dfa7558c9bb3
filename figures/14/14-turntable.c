/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 14-turntable.c -- a sphere rolls on a table that turns about the y axis.
 *
 * Prints its path and how far it is from the circle of (14.8), and the time of
 * a round over that of the table.
 */
#include <math.h>
#include <stdio.h>

#include "dem/surfaces/surface.h"
#include "dem/contact_linear.h"
#include "dem/dem.h"

static const double g = 9.81, R = 0.05, k = 1e6; /* [m/s^2], [m], [N/m] */
static const double turn = 3.0, v = 0.1;         /* [rad/s], [m/s] */

int main(void)
{
    const struct surface table = {.name = "table",
                                  .shape = &surface_plane,
                                  .normal = {0.0, 1.0, 0.0},
                                  .motion = {.spin = {0.0, turn, 0.0}}};
    const struct dem_options o = {
        .law = &contact_linear,
        .material = {.stiffness = k, .restitution = 0.5, .friction = 0.8},
        .step = 5e-5,
        .lo = {-2, -2, -2},
        .hi = {2, 2, 2},
        .surfaces = &table,
        .n_surfaces = 1};
    struct particles *const ps = particles_create(1);
    const double x0 = 0.2, radius = v / (2.0 / 7.0 * turn);
    struct dem_report r;
    double most = 0.0;

    particles_add(ps, (const double[]){x0, R, 0.0}, 2.0 * R, 2000.0);
    ps->y[0] -= ps->m[0] * g / k;
    ps->vx[0] = v;
    ps->wx[0] = x0 * turn / R; /* it rolls: no slip at the table */
    ps->wz[0] = -v / R;
    ps->ey[0] = -g * ps->m[0];
    struct dem *const dem = dem_create(ps, &o);
    dem_clock(dem, 0);
    printf("# x [m]  z [m]\n");
    for (int step = 0; step < 3000; step++) {
        if (step % 20 == 0) printf("%.4f %.4f\n", ps->x[0], ps->z[0]);
        dem_run(dem, 50, &r);
        const double off = hypot(ps->x[0] - x0, ps->z[0] + radius) - radius;
        most = fmax(most, fabs(off));
    }
    printf("radius = %.4f m\noff = %.2g m\n", radius, most);
    dem_free(dem);
    particles_free(ps);
    return 0;
}
