/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What accuracy costs: vortices that a stream carries along, on meshes and with
 * steps, schemes, correctors and tolerances of all kinds. One line a run: which
 * question it belongs to, its setting, the error of the velocity over its
 * largest [-], and the processor time it took [s]. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "fluid/fluid.h"

static const double nu = 0.02, stream[2] = {1.0, 0.5}, end = 0.8;

static void exact(double x, double y, double t, double u[2])
{
    const double decay = exp(-2.0 * nu * t);
    const double a = x - stream[0] * t, b = y - stream[1] * t;

    u[0] = stream[0] + decay * sin(a) * cos(b);
    u[1] = stream[1] - decay * cos(a) * sin(b);
}

static void begin(struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;

    for (int c = 0; c < m->n_cells; c++) {
        const double x = m->centre[3 * c], y = m->centre[3 * c + 1];
        exact(x, y, 0.0, &fl->u[3 * c]);
        fl->p[c] = 0.25 * (cos(2.0 * x) + cos(2.0 * y));
    }
    for (int f = 0; f < m->n_internal; f++) {
        const double *const x = &m->centre[3 * m->owner[f]];
        double u[2];
        exact(x[0] + 0.5 * m->d[3 * f], x[1] + 0.5 * m->d[3 * f + 1], 0.0, u);
        fl->phi[f] = m->S[3 * f] * u[0] + m->S[3 * f + 1] * u[1];
    }
}

static double error_of(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double sum = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double u[2];
        exact(m->centre[3 * c], m->centre[3 * c + 1], fl->t, u);
        sum +=
            pow(fl->u[3 * c] - u[0], 2.0) + pow(fl->u[3 * c + 1] - u[1], 2.0);
    }
    return sqrt(0.5 * sum / m->n_cells);
}

static void run(const char *question, const char *setting, int n, double cfl,
                struct fluid_options o)
{
    const double L = 8.0 * atan(1.0);
    const struct box_spec spec = {{L, L, 1.0}, {n, n, 1}, {1, 1, 1}, {1, 1, 1}};
    struct mesh *const m = mesh_create_box(&spec);
    const int steps = (int)ceil(end / (cfl * L / n / 3.5));

    o.rho = 1.0;
    o.mu = nu;
    o.dt = end / steps;
    struct fluid *const fl = fluid_create(m, &o);
    begin(fl);
    const clock_t start = clock();
    for (int i = 0; i < steps; i++)
        if (fluid_step(fl) != 0) break;
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    printf("%s %s %d %.2f %.3e %.3g\n", question, setting, n, cfl, error_of(fl),
           seconds);
    fluid_free(fl);
    mesh_free(m);
}

static struct fluid_options options(const char *time, const char *convection)
{
    const struct fluid_options o = {.time = time_scheme_named(time),
                                    .convection =
                                        convection_scheme_named(convection),
                                    .blend = 0.8,
                                    .correctors = 2,
                                    .tolerance = 1e-6};

    return o;
}

int main(void)
{
    static const char *const times[] = {"euler", "bdf2"};

    puts("# question setting cells_a_side courant error seconds");
    for (int n = 16; n <= 64; n *= 2)
        for (int i = 0; convection_schemes[i].name != NULL; i++)
            run("convection", convection_schemes[i].name, n, 0.25,
                options("bdf2", convection_schemes[i].name));
    for (double cfl = 4.0; cfl > 0.2; cfl *= 0.5)
        for (int i = 0; i < 2; i++)
            run("time", times[i], 48, cfl, options(times[i], "linear"));
    for (int i = 1; i <= 4; i++) {
        struct fluid_options o = options("bdf2", "linear");
        const char *const names[] = {"1", "2", "3", "4"};
        o.correctors = i;
        run("correctors", names[i - 1], 48, 0.5, o);
    }
    for (int i = 2; i <= 10; i += 2) {
        struct fluid_options o = options("bdf2", "linear");
        char name[16];
        o.tolerance = pow(10.0, -i);
        snprintf(name, sizeof name, "1e-%d", i);
        run("tolerance", name, 48, 0.5, o);
    }
    return 0;
}
