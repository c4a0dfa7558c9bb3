/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What averaging costs in a coupled run, for tests/bench/averaging.sh.
 *
 *   averaging FILE NX NY NZ [COPIES]
 *
 * The spheres of FILE, which `dem bed` wrote, in a box of so many cells with
 * air from below, as [SX15 Table 1 and 3]. Prints `name value` lines: seconds
 * of one step of the whole by its parts, the least of a few steps; and seconds
 * of the processor to find all hosts and spread seven fields by other ways.
 *
 * With COPIES the bed lies so often side by side, on as many times the cells,
 * and the methods that pay by the particle are timed instead: cells and spheres
 * grow together, and neither grows beside the other.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "base/alloc.h"
#include "bed.h"
#include "coupling/effects.h"
#include "coupling/coupling.h"

enum { STEPS = 8, WARM = 3, REPEATS = 7, FIELDS = 7, DEM_STEPS = 10 };

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
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

static void create_fluid(struct simulation *sim, struct boundary *b)
{
    const struct fluid_options o = {.rho = 1.2,
                                    .mu = 1.8e-5,
                                    .dt = sim->dt,
                                    .convection =
                                        convection_scheme_named("upwind"),
                                    .continuity = CONTINUITY_MIXTURE,
                                    .correctors = 2,
                                    .tolerance = 1e-6,
                                    .coupled = 1,
                                    .pressure_shared = 1,
                                    .boundaries = b};

    fill_boundaries(sim->mesh, b);
    sim->fluid = fluid_create(sim->mesh, &o);
}

static struct averaging *averaging_of(const struct simulation *sim,
                                      const char *method, const char *scheme)
{
    const double cells = 2.5 * cbrt(sim->mesh->V[0]); /* [XS11] */
    const struct averaging_options o = {
        .bandwidth = strcmp(method, "kernel") == 0 ? cells : 4.8e-3,
        .scheme = scheme,
        .steps = 3,
        .tolerance = 1e-6,
        .fields = FIELDS};

    return averaging_create(averaging_method_named(method), sim->mesh,
                            sim->particles, &o);
}

static void create_particles(struct simulation *sim, const double hi[3])
{
    const struct dem_options o = {.law = contact_law_named("hertz"),
                                  .material = {.young = 1.2e5,
                                               .poisson = 0.33,
                                               .restitution = 0.98,
                                               .friction = 0.1},
                                  .step = sim->dt / DEM_STEPS,
                                  .hi = {hi[0], hi[1], hi[2]}};

    sim->held_force = alloc_doubles(3 * sim->particles->n);
    particles_attach(sim->particles, "held_force", "N", sim->held_force, 3);
    sim->dem = dem_create(sim->particles, &o);
}

static void create_coupling(struct simulation *sim)
{
    const struct coupling_options o = {.law = drag_law_named("syamlal-obrien"),
                                       .treatment = TREATMENT_SEMI_IMPLICIT,
                                       .interpolation =
                                           interpolation_named("linear"),
                                       .two_way = 1};

    sim->averaging = averaging_of(sim, "diffusion", "exponential");
    sim->coupling = coupling_create(sim, &o);
    effects_create(sim, &gravity_effect, sim->gravity);
    effects_create(sim, &pressure_gradient_effect, NULL);
    if (coupling_start(sim) != 0) exit(1);
}

/* The least that a step took in each part: fluid, particles, averaging,
 * exchange. The loop looks at the clock on the wall; the processor may have had
 * others to serve, and what it spent on us is divided in the same ratio. */
static void time_steps(struct simulation *sim)
{
    double least[4] = {INFINITY, INFINITY, INFINITY, INFINITY};

    for (int n = 0; n < STEPS; n++) {
        const struct seconds s = sim->seconds;
        const double begin = seconds();
        if (coupling_step(sim) != 0) exit(1);
        const double spent = seconds() - begin;
        const double part[4] = {sim->seconds.cfd - s.cfd,
                                sim->seconds.dem - s.dem,
                                sim->seconds.averaging - s.averaging,
                                sim->seconds.exchange - s.exchange};
        const double all = part[0] + part[1] + part[2] + part[3];
        for (int k = 0; k < 4 && n >= WARM; k++)
            least[k] = fmin(least[k], part[k] * spent / all);
    }
    printf("fluid %g\nparticles %g\naveraging %g\nexchange %g\n", least[0],
           least[1], least[2], least[3]);
}

/* Seconds to find the hosts and to spread seven fields. */
static void time_spread(const struct simulation *sim, const char *name,
                        const char *method, const char *scheme)
{
    const int n = sim->particles->n;
    struct averaging *const a = averaging_of(sim, method, scheme);
    double *const q = alloc_doubles(FIELDS * n);
    double *const field = alloc_doubles(FIELDS * sim->mesh->n_cells);
    double bind = INFINITY, spread = INFINITY;

    for (int i = 0; i < FIELDS * n; i++)
        q[i] = 1e-9 * (1.0 + i % FIELDS);
    for (int r = 0; r < REPEATS; r++) {
        const double begin = seconds();
        if (averaging_bind(a) != 0) exit(1);
        const double middle = seconds();
        averaging_spread(a, FIELDS, q, field);
        bind = fmin(bind, middle - begin);
        spread = fmin(spread, seconds() - middle);
    }
    printf("%s %g\n%s-bind %g\n", name, spread, name, bind);
    averaging_free(a);
    free(q);
    free(field);
}

/* All averaging of a step: hosts, eps_s and eps_s u_s, what the fluid is
 * charged with, and its velocity back. */
static void time_averaging(const struct simulation *sim)
{
    struct averaging *const a = averaging_of(sim, "diffusion", "exponential");
    double *const q = alloc_doubles(4 * sim->particles->n);
    double *const field = alloc_doubles(4 * sim->mesh->n_cells);
    double least = INFINITY;

    for (int r = 0; r < REPEATS; r++) {
        const double begin = seconds();
        if (averaging_bind(a) != 0) exit(1);
        averaging_spread(a, 4, q, field);
        averaging_spread(a, 4, q, field);
        averaging_gather(a, 3, field, q);
        least = fmin(least, seconds() - begin);
    }
    printf("averaging-all %g\n", least);
    averaging_free(a);
    free(q);
    free(field);
}

static struct particles *side_by_side(const struct particles *one, double L,
                                      int copies)
{
    struct particles *const ps = particles_create(copies * one->n);

    for (int copy = 0; copy < copies; copy++)
        for (int i = 0; i < one->n; i++) {
            const int to = ps->n++;
            ps->x[to] = one->x[i] + copy * L;
            ps->y[to] = one->y[i];
            ps->z[to] = one->z[i];
            ps->d[to] = one->d[i];
            ps->id[to] = to;
        }
    return ps;
}

int main(int argc, char **argv)
{
    struct simulation sim = {
        .dt = 2e-4, .dem_steps = DEM_STEPS, .gravity = {0.0, -9.81, 0.0}};
    struct boundary b[6] = {{0}};
    double hi[3];

    if (argc != 5 && argc != 6) return 1;
    const int copies = argc == 6 ? atoi(argv[5]) : 1;
    sim.particles = read_bed(argv[1], hi);
    const struct box_spec spec = {
        {copies * hi[0], hi[1], hi[2]},
        {copies * atoi(argv[2]), atoi(argv[3]), atoi(argv[4])},
        {1.0, 1.0, 1.0},
        {0, 0, 0}};
    sim.mesh = mesh_create_box(&spec);
    if (argc == 6) {
        sim.particles = side_by_side(sim.particles, hi[0], copies);
        printf("cells %d\nspheres %d\n", sim.mesh->n_cells, sim.particles->n);
        time_spread(&sim, "kernel", "kernel", NULL);
        time_spread(&sim, "dpvm", "dpvm", NULL);
        return 0;
    }
    create_fluid(&sim, b);
    create_particles(&sim, hi);
    create_coupling(&sim);
    printf("cells %d\nspheres %d\n", sim.mesh->n_cells, sim.particles->n);
    time_steps(&sim);
    time_averaging(&sim);
    time_spread(&sim, "exponential", "diffusion", "exponential");
    time_spread(&sim, "series", "diffusion", "series");
    time_spread(&sim, "crank-nicolson", "diffusion", "crank-nicolson");
    time_spread(&sim, "pcm", "pcm", NULL);
    return 0; /* the system takes all of it back */
}
