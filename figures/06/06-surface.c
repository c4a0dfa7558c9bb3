/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 06-surface.c -- air blown up through a bed into the clear.
 *
 *   06-surface [upwind|linear] [VISCOSITY]
 *
 * A column of 20 cells; in the lower ten the void fraction is 0.42 and the
 * drag about what carries the grains. Prints the velocity of each cell, over
 * the exact one U / eps, and the pressure; then what is wrong with them.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "fluid/fluid.h"

enum { CELLS = 20, BED = 10, STEPS = 3000 };
static const double U = 0.9, h = 2.4e-3; /* [m/s], [m] */
static const double rho = 1.2;           /* [kg/m^3] */
static const double eps = 0.42, K = 1e3; /* [-], [kg/(m^3 s)] of the bed */

static struct fluid *create(const struct mesh *m, const char *scheme, double mu)
{
    static const double start = 0.0;
    static struct boundary b[6];

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    b[2] = (struct boundary){
        .kind = BOUNDARY_INLET, .n_points = 1, .time = &start, .velocity = &U};
    b[3] = (struct boundary){.kind = BOUNDARY_OUTLET};
    const struct fluid_options o = {.rho = rho,
                                    .mu = mu,
                                    .dt = 1e-3,
                                    .convection =
                                        convection_scheme_named(scheme),
                                    .correctors = 2,
                                    .tolerance = 1e-12,
                                    .coupled = 1,
                                    .pressure_shared = 1,
                                    .boundaries = b};
    return fluid_create(m, &o);
}

int main(int n, char **word)
{
    const struct box_spec spec = {
        {h, CELLS * h, h}, {1, CELLS, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    struct fluid *const fl =
        create(m, n > 1 ? word[1] : "upwind", n > 2 ? atof(word[2]) : 0.0);
    double most = 1.0, least = 1.0;

    for (int c = 0; c < BED; c++) {
        fl->eps[c] = eps;
        fl->K[c] = K;
    }
    fluid_reset_eps_history(fl);
    for (int i = 0; i < STEPS; i++)
        if (fluid_step(fl) != 0) {
            printf("broke down after %d steps\n", i);
            return 0;
        }
    for (int c = 0; c < CELLS; c++) {
        const double ratio = fl->u[3 * c + 1] * fl->eps[c] / U;
        printf("%.4f %.4f %.3f\n", m->centre[3 * c + 1], ratio,
               fl->p[c] + 1e-9); /* never -0.000 */
        most = fmax(most, ratio);
        least = fmin(least, ratio);
    }
    const double drop = fluid_patch_pressure(fl, mesh_patch(m, "bottom"));
    const double drag = K * U / (eps * eps) * BED * h;
    printf("most = %.4f\nleast = %.4f\n", most, least);
    printf("drop = %.3f\ndrop_by_drag = %.3f\n", drop, drag);
    printf("rise = %.3f\n", drag - drop);
    printf("rise_upwind = %.3f\n", rho * U * U * (1.0 / eps - 1.0));
    printf("rise_bernoulli = %.3f\n",
           0.5 * rho * U * U * (1.0 / eps / eps - 1.0));
    owner_free(fl);
    mesh_free(m);
    return 0;
}
