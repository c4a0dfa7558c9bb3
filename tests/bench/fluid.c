/* SPDX-License-Identifier: GPL-3.0-or-later */
/* fluid DIMENSIONS CELLS STEPS FIRST [TOLERANCE [MESH]] -- the lid-driven
 * cavity of OpenFOAM's tutorial, 0.1 m wide, lid 1 m/s, Re = 1000, CELLS a
 * side, step at a Courant number of 0.5: implicit Euler, linear convection, two
 * pressure corrections. Times the steps from FIRST on in three equal parts and
 * prints the median. MESH is a folder with the same in OpenFOAM's format.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/alloc.h"
#include "fluid/fluid.h"
#include "mesh/poly/poly.h"

/* Processor time of this thread: the machine may have other work. */
static double now(void)
{
    struct timespec t;
    const int shared = getenv("OMP_NUM_THREADS") == NULL ||
                       strcmp(getenv("OMP_NUM_THREADS"), "1") == 0;

    clock_gettime(shared ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* OpenFOAM's "time step continuity error, sum local". */
static double continuity_error(const struct fluid *fl)
{
    const struct mesh *const m = fl->mesh;
    double sum = 0.0, V = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        double out = 0.0;
        for (int a = m->cell_start[c]; a < m->cell_start[c + 1]; a++) {
            const int f = m->cell_face[a];
            out += m->owner[f] == c ? fl->phi[f] : -fl->phi[f];
        }
        sum += fabs(out);
        V += m->V[c];
    }
    return fl->options.dt * sum / V;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv)
{
    if (argc < 5) return 2;
    const int dimensions = atoi(argv[1]), n = atoi(argv[2]);
    const int steps = atoi(argv[3]), first = atoi(argv[4]);
    const struct box_spec spec = {{0.1, 0.1, dimensions == 3 ? 0.1 : 0.01},
                                  {n, n, dimensions == 3 ? n : 1},
                                  {1.0, 1.0, 1.0},
                                  {0, 0, dimensions == 2}};
    struct mesh *const m =
        argc > 6 ? poly_read(argv[6], NULL) : mesh_create_box(&spec);
    struct boundary b[6];
    if (m == NULL) return 2;
    for (int i = 0; i < m->n_patches; i++) {
        const char *const name = m->patches[i].name;
        const int lid = strcmp(name, "lid") == 0 || strcmp(name, "top") == 0;
        const int free = strcmp(name, "ends") == 0 && dimensions == 2;
        b[i] = (struct boundary){
            .kind = free ? BOUNDARY_SLIP : BOUNDARY_NO_SLIP, .wall = {lid}};
    }
    const struct fluid_options o = {
        .rho = 1.0,
        .mu = 1e-4,
        .dt = 0.5 * 0.1 / n,
        .convection = convection_scheme_named("linear"),
        .correctors = 2,
        .undisturbed = 1,
        .p_relative_tolerance = 0.05, /* icoFoam's, too */
        .u_tolerance = 1e-5,
        .tolerance = argc > 5 && argv[5][0] != '-' ? atof(argv[5])
                     : dimensions == 3             ? 1e-8
                                                   : 1e-9,
        .boundaries = b};
    struct fluid *const fl = fluid_create(m, &o);
    double seconds[3], iterations = 0.0, momentum = 0.0, error = 0.0;

    for (int i = 0; i < first; i++)
        if (fluid_step(fl) != 0) return 3;
    for (int part = 0; part < 3; part++) {
        const double start = now();
        for (int i = 0; i < (steps - first) / 3; i++) {
            if (fluid_step(fl) != 0) return 3;
            iterations += fl->report.pressure.iterations;
            momentum += fl->report.momentum.iterations;
        }
        seconds[part] = (now() - start) / ((steps - first) / 3);
        error += continuity_error(fl) / 3.0;
    }
    qsort(seconds, 3, sizeof *seconds, by_value);
    printf("winnow %dD cells=%d p_iterations=%.1f u_iterations=%.1f "
           "continuity=%.2e "
           "ms_per_step=%.3f ns_per_cell=%.0f cell_steps_per_second=%.4g\n",
           dimensions, m->n_cells, iterations / (steps - first),
           momentum / (steps - first), error, 1e3 * seconds[1],
           1e9 * seconds[1] / m->n_cells, m->n_cells / seconds[1]);
    owner_free(fl);
    mesh_free(m);
    return 0;
}
