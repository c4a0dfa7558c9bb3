/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a step of the whole fluid costs a cell, from a thousand cells to two
 * millions: a cube with a moving lid, Re = 1000, Courant number 0.5, Euler,
 * linear convection, two corrections, tolerance 1e-6. The median of some steps
 * after the first.
 *
 *   sh figures/run.sh figures/07/07-flow.c */
#include "base/alloc.h"
#include "fluid/fluid.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

static struct fluid *cube(int n)
{
    static struct boundary walls[6];
    const struct box_spec spec = {
        {1.0, 1.0, 1.0}, {n, n, n}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    const struct fluid_options o = {.rho = 1.0,
                                    .mu = 1e-3,
                                    .dt = 0.5 / n,
                                    .convection =
                                        convection_scheme_named("linear"),
                                    .correctors = 2,
                                    .tolerance = 1e-6,
                                    .boundaries = walls};

    for (int i = 0; i < 6; i++)
        walls[i] = (struct boundary){.kind = BOUNDARY_NO_SLIP};
    walls[3].wall[0] = 1.0;
    return fluid_create(mesh_create_box(&spec), &o);
}

int main(void)
{
    static const int sides[] = {10, 16, 22, 32, 46, 68, 100, 126};
    enum { STEPS = 7 };

    puts("# cells, iterations of momentum and of pressure; ns a cell and step");
    for (int s = 0; s < 8; s++) {
        struct fluid *const fl = cube(sides[s]);
        struct mesh *const m = (struct mesh *)fl->mesh;
        double seconds[STEPS];
        for (int i = 0; i < 3; i++)
            if (fluid_step(fl) != 0) return 1;
        for (int i = 0; i < STEPS; i++) {
            const double start = now();
            if (fluid_step(fl) != 0) return 1;
            seconds[i] = now() - start;
        }
        qsort(seconds, STEPS, sizeof seconds[0], ascending);
        printf("%7d %2d %2d %5.0f\n", m->n_cells,
               fl->report.momentum.iterations, fl->report.pressure.iterations,
               1e9 * seconds[STEPS / 2] / m->n_cells);
        fflush(stdout);
        owner_free(fl);
        mesh_free(m);
    }
    return 0;
}
