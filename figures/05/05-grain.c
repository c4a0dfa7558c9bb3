/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 05-grain.c -- one grain rises through the mesh; what does a face let pass?
 *
 * Air flows up a column of 12 cells, and a grain rises with it, more slowly. No
 * drag: only its volume counts. Prints time and by how much the superficial
 * velocity at one face falls short of that at the inlet: with the mixture form,
 * with the void-rate form, and with the void-rate form and a grain that a
 * kernel spreads over the cells around it.
 */
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "averaging/averaging.h"
#include "fluid/fluid.h"

enum { CELLS = 12, FACE = 5 };
static const double U = 0.9, v = 0.1;       /* [m/s] of air and grain */
static const double h = 2.4e-3, d = 1.2e-3; /* [m] cell, grain */
static const double dt = 2e-4, end = 0.096; /* [s] */

struct view {
    enum continuity form;
    double bandwidth;    /* [m] 0: the grain is in the cell of its centre */
    double short_by;     /* [m/s] at the face now */
    double most, volume; /* [m/s], [m^3] greatest, and summed over time */
    double kick;         /* [Pa] greatest pressure at the inlet */
    struct fluid *fluid;
};

static void place_grain(struct fluid *fl, double bandwidth, double y)
{
    const double V_p = M_PI / 6.0 * d * d * d;
    double weight[CELLS], sum = 0.0;

    for (int c = 0; c < CELLS; c++) {
        const double far = fabs((c + 0.5) * h - y);
        weight[c] = bandwidth > 0.0 ? kernel_polynomial(far / bandwidth)
                                    : c == (int)(y / h + 1e-9);
        sum += weight[c];
    }
    for (int c = 0; c < CELLS; c++) {
        const double eps_s = weight[c] / sum * V_p / fl->mesh->V[c];
        fl->eps[c] = 1.0 - eps_s;
        fl->eps_us[3 * c + 1] = eps_s * v;
    }
}

static void step(struct view *w, int n)
{
    struct fluid *const fl = w->fluid;

    place_grain(fl, w->bandwidth, (FACE - 0.5) * h + v * dt * (n + 0.5));
    if (n == 0) fluid_reset_eps_history(fl);
    fluid_step(fl);
    w->short_by = U - fl->phi[FACE] / (h * h);
    w->most = fmax(w->most, w->short_by);
    w->volume += w->short_by * h * h * dt;
    w->kick =
        fmax(w->kick,
             fabs(fluid_patch_pressure(fl, mesh_patch(fl->mesh, "bottom"))));
}

static struct fluid *create(const struct mesh *m, enum continuity form)
{
    static const double start = 0.0;
    static struct boundary b[6];

    for (int i = 0; i < 6; i++)
        b[i] = (struct boundary){.kind = BOUNDARY_SLIP};
    b[2] = (struct boundary){
        .kind = BOUNDARY_INLET, .n_points = 1, .time = &start, .velocity = &U};
    b[3] = (struct boundary){.kind = BOUNDARY_OUTLET};
    const struct fluid_options o = {.rho = 1.2,
                                    .mu = 1.8e-5,
                                    .dt = dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .continuity = form,
                                    .correctors = 2,
                                    .tolerance = 1e-12,
                                    .coupled = 1,
                                    .boundaries = b};
    struct fluid *const fl = fluid_create(m, &o);
    for (int c = 0; c < CELLS; c++)
        fl->u[3 * c + 1] = U;
    for (int f = 0; f < m->n_faces; f++)
        fl->phi[f] = U * mesh_S(m, f)[1];
    return fl;
}

int main(void)
{
    const struct box_spec spec = {
        {h, CELLS * h, h}, {1, CELLS, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct mesh *const m = mesh_create_box(&spec);
    struct view w[3] = {{.form = CONTINUITY_MIXTURE},
                        {.form = CONTINUITY_VOID_RATE},
                        {.form = CONTINUITY_VOID_RATE, .bandwidth = 2.0 * h}};
    static const char *const name[] = {"mixture", "void_rate", "spread"};

    for (int k = 0; k < 3; k++)
        w[k].fluid = create(m, w[k].form);
    printf(
        "# time [s], what the face lacks [m/s]: mixture, void-rate, spread\n");
    for (int n = 0; n < (int)(end / dt + 0.5); n++) {
        for (int k = 0; k < 3; k++)
            step(&w[k], n);
        if (n % 4 == 0 || w[1].short_by > 1e-3)
            printf("%.4f %.5f %.5f %.5f\n", n * dt, w[0].short_by + 1e-9,
                   w[1].short_by + 1e-9, w[2].short_by + 1e-9);
    }
    printf("grain = %.4e\n", M_PI / 6.0 * d * d * d);
    for (int k = 0; k < 3; k++) {
        printf("%s_most = %.5f\n", name[k], w[k].most);
        printf("%s_volume = %.4e\n", name[k], w[k].volume);
        printf("%s_kick = %.3f\n", name[k], w[k].kick);
        owner_free(w[k].fluid);
    }
    mesh_free(m);
    return 0;
}
