/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 05-vortices.c -- decaying vortices, with both convection schemes.
 *
 * u = (sin x cos y, -cos x sin y) in a periodic square of side 2 pi decays as
 * exp(-2 nu t) [Taylor37]. Prints the root mean square error of u_x at t = 0.1
 * for meshes of n by n cells.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "fluid/fluid.h"

static const double nu = 0.1, end = 0.1; /* [m^2/s], [s] */

static struct fluid *create(const struct mesh *m, const char *scheme)
{
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = nu,
                                    .dt = 2e-3,
                                    .convection =
                                        convection_scheme_named(scheme),
                                    .correctors = 2,
                                    .tolerance = 1e-10};
    struct fluid *const fl = fluid_create(m, &o);

    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c], y = m->centre[3 * c + 1];
        fl->u[3 * c] = sin(x) * cos(y);
        fl->u[3 * c + 1] = -cos(x) * sin(y);
    }
    for (int f = 0; f < m->n_internal; f++) {
        const double *const from = &m->centre[3 * m->owner[f]];
        const double x = from[0] + 0.5 * mesh_d(m, f)[0];
        const double y = from[1] + 0.5 * mesh_d(m, f)[1];
        fl->phi[f] = mesh_S(m, f)[0] * sin(x) * cos(y) -
                     mesh_S(m, f)[1] * cos(x) * sin(y);
    }
    return fl;
}

static double error(int n, const char *scheme)
{
    const double side = 2.0 * M_PI, decay = exp(-2.0 * nu * end);
    const struct box_spec spec = {
        {side, side, 1.0}, {n, n, 1}, {1.0, 1.0, 1.0}, {1, 1, 1}};
    struct mesh *const m = mesh_create_box(&spec);
    struct fluid *const fl = create(m, scheme);
    double sum = 0.0;

    while (fl->t < end - 0.5 * fl->options.dt)
        fluid_step(fl);
    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c], y = m->centre[3 * c + 1];
        sum += pow(fl->u[3 * c] - decay * sin(x) * cos(y), 2.0);
    }
    const double rms = sqrt(sum / m->n_cells);
    owner_free(fl);
    mesh_free(m);
    return rms;
}

int main(void)
{
    printf("%3s %9s %9s\n", "n", "upwind", "linear");
    for (int n = 8; n <= 32; n *= 2)
        printf("%3d %9.6f %9.6f\n", n, error(n, "upwind"), error(n, "linear"));
    return 0;
}
