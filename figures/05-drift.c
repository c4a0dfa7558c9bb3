/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 05-drift.c -- grains and fluid drift together, at the same velocity.
 *
 * Nothing pushes anything: the fluid should keep its velocity everywhere.
 * Prints how far it strays, for both forms of continuity, and for grains that
 * count in the cell that holds their centre or are spread over the cells around
 * it.
 */
#include <math.h>
#include <stdio.h>

#include "fluid/fluid.h"

enum { N = 40, GRAINS = 200, STEPS = 400 };
static const double U = 1.0, h = 1e-3, dt = 1e-4; /* [m/s], [m], [s] */
static const double share = 0.05; /* [-] a grain's part of a cell */

/* Grains stand in the first half of the box, nearly evenly, and drift. */
static double place(int i, double t)
{
    const double even = (i + 0.5) / GRAINS * 0.5 * N;
    const double x = even + 0.04 * sin(1e3 * i) + U * t / h;
    return x - N * floor(x / N); /* [cells] */
}

static void average(double eps_s[N], double t, double width)
{
    for (int c = 0; c < N; c++)
        eps_s[c] = 0.0;
    for (int i = 0; i < GRAINS; i++) {
        const double x = place(i, t);
        if (width == 0.0) {
            eps_s[(int)x % N] += share;
            continue;
        }
        double K[N], sum = 0.0;
        for (int c = 0; c < N; c++) {
            const double far = fabs(c + 0.5 - x);
            const double z = fmin(far, N - far) / width;
            sum += K[c] = z < 1.0 ? pow(1.0 - z * z, 4.0) : 0.0;
        }
        for (int c = 0; c < N; c++)
            eps_s[c] += share * K[c] / sum;
    }
}

static struct fluid *create(const struct mesh *m, enum continuity form)
{
    const struct fluid_options o = {.rho = 1.2,
                                    .mu = 1.8e-5,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .continuity = form,
                                    .correctors = 2,
                                    .tolerance = 1e-10,
                                    .coupled = 1,
                                    .pressure_shared = 1};
    return fluid_create(m, &o);
}

static void take(struct fluid *fl, const double eps_s[N])
{
    for (int c = 0; c < N; c++) {
        fl->eps[c] = 1.0 - eps_s[c];
        fl->eps_us[3 * c] = eps_s[c] * U;
    }
}

static double strays(enum continuity form, double width, double *relabelled)
{
    const struct box_spec spec = {
        {N * h, h, h}, {N, 1, 1}, {1.0, 1.0, 1.0}, {1, 1, 1}};
    struct mesh *const m = mesh_create_box(&spec);
    struct fluid *const fl = create(m, form);
    double eps_s[N], sum = 0.0;

    average(eps_s, 0.0, width);
    take(fl, eps_s);
    fluid_settle_eps(fl);
    for (int c = 0; c < N; c++)
        fl->u[3 * c] = U;
    for (int f = 0; f < m->n_internal; f++)
        fl->phi[f] = 0.5 * U * m->S[3 * f] *
                     (fl->eps[m->owner[f]] + fl->eps[m->neighbour[f]]);
    for (int n = 1; n <= STEPS; n++) {
        average(eps_s, n * dt, width);
        take(fl, eps_s);
        fluid_step(fl);
        double worst = 0;
        double mean = 0;
        for (int c = 0; c < N; c++) {
            sum += pow(fl->u[3 * c] - U, 2.0) / (N * STEPS);
            mean += fl->u[3 * c] / N;
            worst = fmax(worst, fabs(fl->u[3 * c] - U));
        }
        if (n % 50 == 0 || n < 4)
            fprintf(
                stderr, "%d %g worst %g mean %g mom %g cfl %g mass %g spl %g\n",
                n, width, worst, mean, fl->report.momentum_residual,
                fl->report.cfl, fl->report.mass_residual, fl->report.splitting);
    }
    *relabelled = fl->relabelled[0];
    fluid_free(fl);
    mesh_free(m);
    return sqrt(sum) / U;
}

int main(void)
{
    static const char *const forms[] = {"mixture", "void_rate"};
    for (int form = 0; form < 2; form++)
        for (int w = 0; w < 2; w++) {
            double relabelled;
            const double rms =
                strays((enum continuity)form, w ? 2.5 : 0.0, &relabelled);
            printf("%s_%s %.6g %g\n", forms[form], w ? "spread" : "cell", rms,
                   relabelled);
        }
    return 0;
}
