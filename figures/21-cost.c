/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What averaging costs beside the fluid, on the meshes of SX15 Table 3.
 *
 *     sh figures/program.sh 21-cost
 *
 * 332000 spheres of 1.2 mm at rest in rows, 36 mm high, in a box of 264 x 120 x
 * 60 mm; air comes from below. Processor seconds of one thread, the shortest of
 * a few.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/alloc.h"
#include "exchange/coupling.h"
#include "exchange/transfer.h"

enum { SPHERES = 332000, REPEATS = 3, FIELDS = 7 };
static const double d = 1.2e-3; /* [m] */

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static struct particles *rows_of_spheres(void)
{
    struct particles *const ps = particles_create(SPHERES);

    for (int i = 0; i < SPHERES; i++) {
        const double x[3] = {(i % 220 + 0.5) * d, (i / 11000 + 0.5) * d,
                             (i / 220 % 50 + 0.5) * d};
        particles_add(ps, x, d, 1000.0);
    }
    return ps;
}

static void fill_boundaries(const struct mesh *m, struct boundary *b)
{
    static const double zero = 0.0, speed = 0.9;

    for (int i = 0; i < m->n_patches; i++) {
        const char *const name = m->patches[i].name;
        b[i].kind = BOUNDARY_NO_SLIP;
        if (strcmp(name, "top") == 0) b[i].kind = BOUNDARY_OUTLET;
        if (strcmp(name, "bottom") != 0) continue;
        b[i].kind = BOUNDARY_INLET;
        b[i].n_points = 1;
        b[i].time = &zero;
        b[i].velocity = &speed;
    }
}

static struct averaging *averaging_of(const struct simulation *sim,
                                      const char *method, const char *scheme)
{
    const struct averaging_options o = {
        .bandwidth = strcmp(method, "kernel") == 0 ? 2.5 * cbrt(sim->mesh->V[0])
                                                   : 4.0 * d,
        .scheme = scheme,
        .steps = 3,
        .tolerance = 1e-6,
        .fields = FIELDS};

    return averaging_create(averaging_method_named(method), sim->mesh,
                            sim->particles, &o);
}

/* Seconds to bind and to spread m fields. */
static double spread_time(const struct simulation *sim, const char *method,
                          const char *scheme, int m)
{
    struct averaging *const a = averaging_of(sim, method, scheme);
    double *const q = alloc_doubles(m * SPHERES);
    double *const field = alloc_doubles(m * sim->mesh->n_cells);
    double shortest = INFINITY;

    for (int i = 0; i < m * SPHERES; i++)
        q[i] = 1e-9 * (1.0 + i % m);
    for (int n = 0; n < REPEATS; n++) {
        const double begin = seconds();
        if (averaging_bind(a) != 0) exit(1);
        averaging_spread(a, m, q, field);
        shortest = fmin(shortest, seconds() - begin);
    }
    averaging_free(a);
    free(q);
    free(field);
    return shortest;
}

/* Seconds of a step of the fluid, and of all that averaging has to do in it. */
static void loop_time(struct simulation *sim, double *cfd, double *all)
{
    *cfd = *all = INFINITY;
    if (coupling_start(sim) != 0) exit(1);
    for (int n = 0; n < REPEATS + 2; n++) {
        const double begin = seconds();
        if (fluid_step(sim->fluid) != 0) exit(1);
        const double middle = seconds();
        transfer_fluid(sim);
        if (transfer_average(sim) != 0) exit(1);
        transfer_drag_terms(sim);
        if (n < 2) continue; /* the flow has only begun */
        *cfd = fmin(*cfd, middle - begin);
        *all = fmin(*all, seconds() - middle);
    }
}

static void measure(const int cells[3], struct particles *ps)
{
    const struct box_spec spec = {{0.264, 0.120, 0.060},
                                  {cells[0], cells[1], cells[2]},
                                  {1.0, 1.0, 1.0},
                                  {0, 0, 0}};
    struct simulation sim = {.mesh = mesh_create_box(&spec),
                             .particles = ps,
                             .dt = 2e-4,
                             .dem_steps = 10,
                             .gravity = {0.0, -9.81, 0.0}};
    struct boundary b[6] = {{0}};
    const struct coupling_options co = {.law = drag_law_named("syamlal-obrien"),
                                        .treatment = TREATMENT_SEMI_IMPLICIT,
                                        .interpolation =
                                            interpolation_named("linear"),
                                        .two_way = 1};
    double cfd, all;

    fill_boundaries(sim.mesh, b);
    const struct fluid_options fo = {.rho = 1.2,
                                     .mu = 1.8e-5,
                                     .dt = sim.dt,
                                     .convection =
                                         convection_scheme_named("upwind"),
                                     .continuity = CONTINUITY_MIXTURE,
                                     .correctors = 2,
                                     .tolerance = 1e-6,
                                     .coupled = 1,
                                     .pressure_shared = 1,
                                     .boundaries = b};
    sim.fluid = fluid_create(sim.mesh, &fo);
    sim.averaging = averaging_of(&sim, "diffusion", "exponential");
    sim.coupling = coupling_create(&sim, &co);
    loop_time(&sim, &cfd, &all);
    const double pcm = spread_time(&sim, "pcm", NULL, FIELDS);
    const double seven = spread_time(&sim, "diffusion", "exponential", FIELDS);
    const double four = spread_time(&sim, "diffusion", "exponential", 4);
    const double cn = spread_time(&sim, "diffusion", "crank-nicolson", FIELDS);
    const double bell = spread_time(&sim, "kernel", NULL, FIELDS);
    const double dpvm = spread_time(&sim, "dpvm", NULL, FIELDS);
    printf("%-6d %4.1f %8.1f %8.2f %8.2f %8.2f %8.2f %8.0f %8.0f %8.2f\n",
           sim.mesh->n_cells, (double)SPHERES / sim.mesh->n_cells, 1e3 * cfd,
           (seven - pcm) / cfd, (four - pcm) / cfd, (cn - pcm) / cfd, pcm / cfd,
           1e9 * bell / SPHERES, 1e9 * dpvm / SPHERES, all / cfd);
    coupling_free(sim.coupling);
    averaging_free(sim.averaging);
    fluid_free(sim.fluid);
    mesh_free(sim.mesh);
}

int main(void)
{
    static const int cells[4][3] = {
        {118, 54, 27}, {93, 42, 21}, {74, 33, 17}, {59, 27, 13}};

    printf("# cells, particles a cell, fluid step [ms]; over the fluid step: "
           "diffusion of 7 fields, of 4, of 7 by Crank-Nicolson, pcm of 7 [-]; "
           "bell, dpvm [ns a particle]; all averaging of the loop [-]\n");
    for (int k = 0; k < 4; k++) {
        struct particles *const ps = rows_of_spheres();
        measure(cells[k], ps);
        fflush(stdout);
        particles_free(ps);
    }
    return 0;
}
