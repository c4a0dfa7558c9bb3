/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 06-step.c -- does a steady flow know with which steps it was reached?
 *
 * A stream around a dense block, in two dimensions, until it is steady, with
 * steps tenfold apart. Prints how far the pressures of the two differ, over the
 * largest pressure.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "fluid/fluid.h"

enum { NX = 6, NY = 10, N = NX * NY };
static const double U = 0.01; /* [m/s] */

static struct fluid *create(const struct mesh *m, double dt)
{
    static const double start = 0.0;
    static struct boundary b[6];

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    b[2] = (struct boundary){
        .kind = BOUNDARY_INLET, .n_points = 1, .time = &start, .velocity = &U};
    b[3] = (struct boundary){.kind = BOUNDARY_OUTLET};
    const struct fluid_options o = {.rho = 1000.0,
                                    .mu = 0.1,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .tolerance = 1e-12,
                                    .coupled = 1,
                                    .pressure_shared = 1,
                                    .boundaries = b};
    return fluid_create(m, &o);
}

static void reach(double dt, int steps, double p[N])
{
    const struct box_spec spec = {
        {0.06, 0.10, 0.01}, {NX, NY, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    struct fluid *const fl = create(m, dt);

    for (int j = 3; j < 6; j++)
        for (int i = 0; i < 3; i++) {
            fl->eps[i + NX * j] = 0.45;
            fl->K[i + NX * j] = 1e5;
        }
    fluid_reset_eps_history(fl);
    for (int n = 0; n < steps; n++)
        fluid_step(fl);
    memcpy(p, fl->p, N * sizeof *p);
    owner_free(fl);
    mesh_free(m);
}

int main(void)
{
    double slow[N], fast[N], worst = 0.0, scale = 0.0;

    reach(0.1, 600, slow);
    reach(0.01, 4000, fast);
    for (int c = 0; c < N; c++) {
        worst = fmax(worst, fabs(slow[c] - fast[c]));
        scale = fmax(scale, fabs(slow[c]));
    }
    printf("difference = %.5f\n", worst / scale);
    return 0;
}
