/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The averaging room alone: what each method makes of given particles.
 *
 *     sh figures/run.sh figures/08/08-averaging.c -- PART
 */
#include "averaging/averaging.h"

#include <gsl/gsl_math.h>
#include <omp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "averaging/diffusion.h"
#include "averaging/cell_of_particle.h"
#include "base/alloc.h"

enum { CUBE = 15, FIELDS = 8 };

/* A mesh with particles in it; lengths in diameters. */
struct scene {
    struct mesh *mesh;
    struct particles *ps;
};

/* n x n x deep cells in a box of L x L x depth. */
static struct scene scene_create(int n, double L, int deep, double depth,
                                 int room)
{
    const struct box_spec spec = {
        {L, L, depth}, {n, n, deep}, {1.0, 1.0, 1.0}, {0, 0, 0}};

    return (struct scene){mesh_create_box(&spec), particles_create(room)};
}

static void scene_free(struct scene *s)
{
    mesh_free(s->mesh);
    particles_free(s->ps);
}

static double random_number(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static void place(struct particles *ps, double x, double y, double z)
{
    const int i = ps->n++;

    ps->x[i] = x;
    ps->y[i] = y;
    ps->z[i] = z;
    ps->d[i] = 1.0;
    ps->id[i] = i;
}

/* A slot of n x n cells, 18 d wide, filled up to two thirds by rows of spheres
 * a little out of place, with a bubble of radius 3.2 d in them. */
static struct scene bubble(int n)
{
    const double depth = 1.5, pitch = 1.06, L = 18.0;
    struct scene s = scene_create(n, L, 1, depth, 400);
    uint64_t seed = 5;

    for (int row = 0; row < 13; row++)
        for (int k = 0; k < 17; k++) {
            const double shift = row % 2 ? 0.5 : 0.0;
            const double x = 0.55 + (k + shift) * pitch +
                             0.06 * (random_number(&seed) - 0.5);
            const double y = 0.55 + row * 0.866 * pitch +
                             0.06 * (random_number(&seed) - 0.5);
            if (x < L - 0.5 && hypot(x - 0.5 * L, y - 5.6) > 3.2)
                place(s.ps, x, y, 0.5 * depth);
        }
    return s;
}

/* One way of averaging, and the field of solids that it gives. */
static void average(const struct scene *s, const char *method,
                    const struct averaging_options *o, double *field,
                    struct averaging_report *report)
{
    struct averaging *const a =
        averaging_create(averaging_method_named(method), s->mesh, s->ps, o);
    double *const V = alloc_doubles(s->ps->n);

    for (int i = 0; i < s->ps->n; i++)
        V[i] = M_PI / 6.0 * gsl_pow_3(s->ps->d[i]);
    if (a == NULL || averaging_bind(a) != 0) exit(1);
    averaging_spread(a, 1, V, field);
    *report = *averaging_report(a);
    averaging_free(a);
    free(V);
}

/* As the papers advise: b = 2.5 cells for the kernel, 4 d for diffusion. */
static const struct averaging_options kernel_wide = {.bandwidth = 3.75},
                                      wide = {.bandwidth = 4.0};

/* Particles, then cells with the three fields. */
static void layout(void)
{
    struct scene s = bubble(12);
    const int n = s.mesh->n_cells;
    double *const pcm = alloc_doubles(n), *const kernel = alloc_doubles(n);
    double *const diffusion = alloc_doubles(n);
    struct averaging_report r;

    average(&s, "pcm", &wide, pcm, &r);
    average(&s, "kernel", &kernel_wide, kernel, &r);
    average(&s, "diffusion", &wide, diffusion, &r);
    printf("# x y of each particle [d]\n");
    for (int i = 0; i < s.ps->n; i++)
        printf("%.3f %.3f\n", s.ps->x[i], s.ps->y[i]);
    printf("\n\n# x y [d] of each cell, eps_s by pcm, kernel, diffusion\n");
    for (int c = 0; c < n; c++)
        printf("%.2f %.2f %.4f %.4f %.4f\n", s.mesh->centre[3 * c],
               s.mesh->centre[3 * c + 1], pcm[c], kernel[c], diffusion[c]);
    free(pcm);
    free(kernel);
    free(diffusion);
    scene_free(&s);
}

/* One sphere in the middle cell of a cube of cells of one diameter. */
static struct scene one_full_cell(void)
{
    struct scene s = scene_create(CUBE, CUBE, CUBE, CUBE, 1);

    place(s.ps, 0.5 * CUBE, 0.5 * CUBE, 0.5 * CUBE);
    return s;
}

static void diffuse(const struct scene *s, const char *scheme, int steps,
                    double tolerance, double *field, struct averaging_report *r)
{
    const struct averaging_options o = {.bandwidth = 4.0,
                                        .scheme = scheme,
                                        .steps = steps,
                                        .tolerance = tolerance};
    average(s, "diffusion", &o, field, r);
}

/* Along the line through the middle: the Gaussian, then some schemes. */
static void cell(void)
{
    static const char *const scheme[] = {"exponential", "implicit-euler",
                                         "crank-nicolson", "crank-nicolson",
                                         "crank-nicolson"};
    static const int steps[] = {1, 3, 3, 6, 12};
    struct scene s = one_full_cell();
    const int n = s.mesh->n_cells, first = (n - CUBE) / 2;
    double *const field = alloc_doubles(5 * n);
    struct averaging_report r;

    printf("# x [d], 1000 eps_s: gaussian");
    for (int w = 0; w < 5; w++) {
        diffuse(&s, scheme[w], steps[w], 1e-9, &field[w * n], &r);
        printf(", %s %d", scheme[w], steps[w]);
    }
    printf("\n");
    for (int i = 0; i < CUBE; i++) {
        const double x = s.mesh->centre[3 * (first + i)] - 0.5 * CUBE;
        printf("%g %.4f", x, 1e3 * M_PI / 6.0 * diffusion_kernel(x, 4.0));
        for (int w = 0; w < 5; w++)
            printf(" %.4f", 1e3 * field[w * n + first + i]);
        printf("\n");
    }
    free(field);
    scene_free(&s);
}

/* Distance (V-weighted, L1) of a field from the exact one, over its amount. */
static double error(const struct mesh *m, const double *field,
                    const double *exact)
{
    double off = 0.0, all = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        off += m->V[c] * fabs(field[c] - exact[c]);
        all += m->V[c] * fabs(exact[c]);
    }
    return off / all;
}

/* The work of each number of steps, and what is gained by it. */
static void table_of(const struct scene *s)
{
    static const int steps[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
    double *const exact = alloc_doubles(s->mesh->n_cells);
    double *const field = alloc_doubles(s->mesh->n_cells);
    struct averaging_report r;

    diffuse(s, "exponential", 0, 1e-12, exact, &r);
    for (int w = 1; diffusion_schemes[w] != NULL; w++) { /* with products */
        printf("# %s: steps, products, error, lowest over highest, share "
               "below zero\n",
               diffusion_schemes[w]->name);
        for (int k = 0; k < (w == 1 ? 1 : 10); k++) {
            diffuse(s, diffusion_schemes[w]->name, steps[k], 1e-6, field, &r);
            printf("%2d %4d %.2e %8.4f %.4f\n", steps[k], r.products,
                   error(s->mesh, field, exact), r.lowest / r.highest,
                   r.negative);
        }
        printf("\n\n");
    }
    free(exact);
    free(field);
}

static void table(void)
{
    struct scene s = one_full_cell();

    table_of(&s);
    scene_free(&s);
}

static void table_bed(void)
{
    struct scene s = bubble(24);

    table_of(&s);
    scene_free(&s);
}

/* A row of 400 cells with one particle in the middle of each: how full an even
 * bed seems near its wall. */
static void wall(void)
{
    enum { N = 400 };
    const struct averaging_options o = {.bandwidth = 100.0};
    const struct box_spec spec = {
        {N, 1.0, 1.0}, {N, 1, 1}, {1.0, 1.0, 1.0}, {0, 0, 0}};
    struct scene s = {mesh_create_box(&spec), particles_create(N)};
    double kernel[N], diffusion[N];
    struct averaging_report r;

    for (int i = 0; i < N; i++)
        place(s.ps, i + 0.5, 0.5, 0.5);
    average(&s, "kernel", &o, kernel, &r);
    average(&s, "diffusion", &o, diffusion, &r);
    printf("# distance from the wall over b, kernel, diffusion\n");
    for (int i = 0; i <= 100; i += 20)
        printf("%.3f  %.4f  %.4f\n", (i + 0.5) / 100.0,
               kernel[i] / (M_PI / 6.0), diffusion[i] / (M_PI / 6.0));
    scene_free(&s);
}

/* The work of forces on gathered velocities, and of the spread forces on the
 * field of velocities. */
static void work(void)
{
    struct scene s = bubble(12);
    const int n = s.mesh->n_cells, n_p = s.ps->n;
    double *const f = alloc_doubles(n_p), *const F = alloc_doubles(n);
    double *const u = alloc_doubles(n), *const u_i = alloc_doubles(n_p);
    uint64_t seed = 8;

    for (int i = 0; i < n_p; i++)
        f[i] = random_number(&seed);
    for (int c = 0; c < n; c++)
        u[c] = random_number(&seed);
    for (int k = 0; averaging_methods[k] != NULL; k++) {
        struct averaging *const a =
            averaging_create(averaging_methods[k], s.mesh, s.ps, &wide);
        double particles = 0.0, cells = 0.0;

        if (averaging_bind(a) != 0) exit(1);
        averaging_spread(a, 1, f, F);
        averaging_gather(a, 1, u, u_i);
        for (int i = 0; i < n_p; i++)
            particles += f[i] * u_i[i];
        for (int c = 0; c < n; c++)
            cells += s.mesh->V[c] * u[c] * F[c];
        printf("%-9s %.12f  %.12f\n", averaging_methods[k]->name, particles,
               cells);
        averaging_free(a);
    }
    free(f);
    free(F);
    free(u);
    free(u_i);
    scene_free(&s);
}

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The shortest of some: seconds to bind and to spread eight numbers. */
static double seconds(const struct scene *s, const char *method,
                      const struct averaging_options *o)
{
    struct averaging *const a =
        averaging_create(averaging_method_named(method), s->mesh, s->ps, o);
    double *const q = alloc_doubles(FIELDS * s->ps->n);
    double *const field = alloc_doubles(FIELDS * s->mesh->n_cells);
    double least = 1e9;

    for (int e = 0; e < FIELDS * s->ps->n; e++)
        q[e] = 1.0 + e % 7;
    for (int k = 0; k < 9; k++) {
        const double began = now();
        if (averaging_bind(a) != 0) exit(1);
        averaging_spread(a, FIELDS, q, field);
        least = fmin(least, now() - began);
    }
    averaging_free(a);
    free(q);
    free(field);
    return least;
}

/* Cubes of cells of 1.5 d with so many particles a cell, anywhere. */
static void times_of(int per_cell)
{
    enum { N = 24 };
    const struct averaging_options cn = {
        .bandwidth = 4.0, .scheme = "crank-nicolson", .steps = 3};
    struct scene s = scene_create(N, 1.5 * N, N, 1.5 * N, N * N * N * per_cell);
    uint64_t seed = 9;

    while (s.ps->n < s.ps->capacity) {
        const double x = random_number(&seed), y = random_number(&seed);
        place(s.ps, 1.5 * N * x, 1.5 * N * y, 1.5 * N * random_number(&seed));
    }
    const double pcm = seconds(&s, "pcm", &wide);
    printf("%d a cell: kernel %.1f, diffusion %.1f, crank-nicolson %.1f\n",
           per_cell, seconds(&s, "kernel", &kernel_wide) / pcm,
           seconds(&s, "diffusion", &wide) / pcm,
           seconds(&s, "diffusion", &cn) / pcm);
    scene_free(&s);
}

static void times(void)
{
    times_of(1);
    times_of(4);
    times_of(16);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        void (*print)(void);
    } parts[] = {{"layout", layout}, {"cell", cell}, {"table", table},
                 {"bed", table_bed}, {"wall", wall}, {"work", work},
                 {"time", times}};

    omp_set_num_threads(1); /* on meshes this small threads only wait */
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (argc == 2 && strcmp(argv[1], parts[k].name) == 0) {
            parts[k].print();
            return 0;
        }
    fprintf(stderr, "averaging layout|cell|table|bed|wall|work|time\n");
    return 2;
}
