/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 06-drift.c -- grains and fluid drift together, at the same velocity.
 *
 * Nothing pushes anything, so the fluid should keep its velocity everywhere.
 * Prints how far it strays (root mean square over cells and steps, over the
 * velocity) with both forms of continuity, and with grains that count in the
 * cell of their centre or are spread over the cells around it.
 */
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "averaging/averaging.h"
#include "fluid/fluid.h"

enum { CELLS = 40, GRAINS = 200, STEPS = 100 };
static const double U = 1.0, h = 1e-3, dt = 1e-4; /* [m/s], [m], [s] */
static const double share = 0.05; /* [-] of a cell that one grain fills */

/* The grains fill half of one half of the box, and drift [cells]. */
static double place(int i, double t)
{
    const double even = (i + 0.5) / GRAINS * 0.5 * CELLS;
    const double x = even + 0.04 * sin(1e3 * i) + U * t / h;
    return x - CELLS * floor(x / CELLS);
}

/* width: bandwidth of the kernel [cells], or 0. */
static void average(struct fluid *fl, double t, double width)
{
    double eps_s[CELLS] = {0.0};

    for (int i = 0; i < GRAINS; i++) {
        const double x = place(i, t);
        double weight[CELLS], sum = 0.0;
        for (int c = 0; c < CELLS; c++) {
            const double far = fabs(c + 0.5 - x);
            weight[c] = width > 0.0
                            ? kernel_polynomial(fmin(far, CELLS - far) / width)
                            : c == (int)x;
            sum += weight[c];
        }
        for (int c = 0; c < CELLS; c++)
            eps_s[c] += share * weight[c] / sum;
    }
    for (int c = 0; c < CELLS; c++) {
        fl->eps[c] = 1.0 - eps_s[c];
        fl->eps_us[3 * c] = eps_s[c] * U;
    }
}

static void set_drift(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    fluid_reset_eps_history(fl);
    for (int c = 0; c < CELLS; c++)
        fl->u[3 * c] = U;
    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] = 0.5 * U * mesh_S(m, f)[0] *
                     (fl->eps[m->owner[f]] + fl->eps[m->neighbour[f]]);
}

static double strays(enum continuity form, double width)
{
    const struct box_spec spec = {
        {CELLS * h, h, h}, {CELLS, 1, 1}, {1.0, 1.0, 1.0}, {1, 1, 1}};
    const struct fluid_options o = {.rho = 1.2,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .continuity = form,
                                    .correctors = 2,
                                    .tolerance = 1e-10,
                                    .coupled = 1,
                                    .pressure_shared = 1};
    struct mesh *const m = mesh_create_box(&spec);
    struct fluid *const fl = fluid_create(m, &o);
    double sum = 0.0;

    average(fl, 0.0, width);
    set_drift(fl);
    for (int n = 1; n <= STEPS; n++) {
        average(fl, n * dt, width);
        fluid_step(fl);
        for (int c = 0; c < CELLS; c++)
            sum += pow(fl->u[3 * c] / U - 1.0, 2.0) / (CELLS * STEPS);
    }
    owner_free(fl);
    mesh_free(m);
    return sqrt(sum);
}

int main(void)
{
    printf("mixture = %.4f\n", strays(CONTINUITY_MIXTURE, 0.0));
    printf("mixture_spread = %.4f\n", strays(CONTINUITY_MIXTURE, 2.5));
    printf("void_rate = %.4f\n", strays(CONTINUITY_VOID_RATE, 0.0));
    printf("void_rate_spread = %.4f\n", strays(CONTINUITY_VOID_RATE, 2.5));
    return 0;
}
