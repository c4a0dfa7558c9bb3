/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All methods of averaging on the same particles and the same meshes.
 *
 *     sh figures/run.sh figures/26/26-compare.c -- table slot
 *     sh figures/run.sh figures/26/26-compare.c -- table bed
 *     sh figures/run.sh figures/26/26-compare.c -- picture slot
 *     sh figures/run.sh figures/26/26-compare.c -- turn
 *
 * slot: rows of spheres a little out of place, with a bubble in them. bed: the
 * spheres of cases/mueller-bed.cfg at 0.3 s, from figures/data/26-bed.txt.
 * Lengths in diameters.
 */
#include "averaging/averaging.h"

#include <gsl/gsl_math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "averaging/cell_of_particle.h"
#include "averaging/interpolation.h"
#include "base/alloc.h"

static const double width = 4.0; /* [d] b of everything Gaussian */

/* One way to average. cells: the bandwidth is so many cells [XS11]. */
struct way {
    const char *name, *method;
    struct averaging_options o;
    double cells;  /* [-] */
    double finest; /* [d] cells below which it would take too much memory */
    int pictured;
};

static const struct way ways[] = {
    {"pcm", "pcm", {.cap = 0.0}, 0.0, 0.0, 1},
    {"pcm-capped", "pcm", {.cap = 0.7}, 0.0, 0.0, 0},
    {"dpvm", "dpvm", {.cap = 0.0}, 0.0, 0.0, 1},
    {"cube", "cube", {.cap = 0.0}, 0.0, 0.0, 0},
    {"two-grid-3d", "two-grid", {.bandwidth = 3.0}, 0.0, 0.0, 1},
    {"kernel-2.5-cells", "kernel", {.cap = 0.0}, 2.5, 0.0, 1},
    {"gaussian", "gaussian", {.bandwidth = 4.0}, 0.0, 1.9, 0},
    {"images", "images", {.bandwidth = 4.0}, 0.0, 0.0, 1},
    {"exponential", "diffusion", {.bandwidth = 4.0}, 0.0, 0.0, 1},
    {"exponential-cells",
     "diffusion",
     {.bandwidth = 4.0, .vary = "cells"},
     0.0,
     0.0,
     0},
    {"crank-nicolson-1",
     "diffusion",
     {.bandwidth = 4.0, .scheme = "crank-nicolson", .steps = 1},
     0.0,
     0.0,
     0},
    {"crank-nicolson-3",
     "diffusion",
     {.bandwidth = 4.0, .scheme = "crank-nicolson", .steps = 3},
     0.0,
     0.0,
     1},
    {"implicit-euler-1",
     "diffusion",
     {.bandwidth = 4.0, .scheme = "implicit-euler", .steps = 1},
     0.0,
     0.0,
     0},
    {"implicit-euler-3",
     "diffusion",
     {.bandwidth = 4.0, .scheme = "implicit-euler", .steps = 3},
     0.0,
     0.0,
     0},
    {"sdirk2-2",
     "diffusion",
     {.bandwidth = 4.0, .scheme = "sdirk2", .steps = 2},
     0.0,
     0.0,
     0},
    {"sdirk2-4",
     "diffusion",
     {.bandwidth = 4.0, .scheme = "sdirk2", .steps = 4},
     0.0,
     0.0,
     0},
};
enum { WAYS = sizeof ways / sizeof *ways };

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

/* A box of L, filled to two thirds, with a bubble of radius 4 d across. */
static struct particles *slot(double L[3])
{
    const double pitch = 1.06;
    struct particles *const ps = particles_create(4000);
    uint64_t seed = 5;

    L[0] = L[1] = 24.0;
    L[2] = 6.0;
    for (int e = 0; e < 22 * 15 * 5; e++) {
        double x[3] = {0.65 + pitch * (e % 22), 0.65 + pitch * (e / 22 % 15),
                       0.85 + pitch * (e / 330)};
        for (int k = 0; k < 3; k++)
            x[k] += 0.06 * (random_number(&seed) - 0.5);
        if (hypot(x[0] - 12.0, x[1] - 8.0) > 4.0) place(ps, x[0], x[1], x[2]);
    }
    return ps;
}

/* In thousandths of a diameter, one a line. */
static struct particles *bed(double L[3])
{
    const char *const path = "figures/data/26-bed.txt";
    struct particles *const ps = particles_create(10000);
    FILE *const file = fopen(path, "r");
    char line[100];
    double x, y, z;

    L[0] = 44.0 / 1.2;
    L[1] = 80.0;
    L[2] = 10.0 / 1.2;
    if (file == NULL) {
        perror(path);
        exit(4);
    }
    while (fgets(line, sizeof line, file) != NULL)
        if (sscanf(line, "%lf %lf %lf", &x, &y, &z) == 3 && ps->n < 10000)
            place(ps, 1e-3 * x, 1e-3 * y, 1e-3 * z);
    fclose(file);
    return ps;
}

static struct mesh *mesh_of(const double L[3], double dx, int periodic)
{
    struct box_spec spec = {.grading = {1.0, 1.0, 1.0}};

    for (int k = 0; k < 3; k++) {
        spec.size[k] = L[k];
        spec.cells[k] = (int)fmax(1.0, rint(L[k] / dx));
        spec.periodic[k] = periodic;
    }
    return mesh_create_box(&spec);
}

/* Integrals of a Gaussian around x over all slabs of a direction, images in
 * both walls included, nothing cut off. */
static void slabs(const struct mesh *m, int k, double x, double *share)
{
    const double *const e = m->box.edge[k];
    const double L = e[m->box.n[k]];

    for (int j = 0; j < m->box.n[k]; j++) {
        share[j] = 0.0;
        for (int t = -3; t <= 3; t++)
            for (int side = -1; side <= 1; side += 2) {
                const double at = side * x + 2.0 * t * L;
                share[j] += 0.5 * (erf((e[j + 1] - at) / width) -
                                   erf((e[j] - at) / width));
            }
    }
}

/* The mean of each cell of the exact kernel field. */
static void exact(const struct mesh *m, const struct particles *ps,
                  double *field)
{
    const int *const n = m->box.n;
    double *const s = alloc_doubles(n[0] + n[1] + n[2]);
    double *const sx = s, *const sy = s + n[0], *const sz = s + n[0] + n[1];

    for (int c = 0; c < m->n_cells; c++)
        field[c] = 0.0;
    for (int i = 0; i < ps->n; i++) {
        slabs(m, 0, ps->x[i], sx);
        slabs(m, 1, ps->y[i], sy);
        slabs(m, 2, ps->z[i], sz);
        for (int l = 0; l < n[2]; l++)
            for (int j = 0; j < n[1]; j++) {
                const double w = sy[j] * sz[l] * M_PI / 6.0;
                double *const row = &field[n[0] * (j + n[1] * l)];
                if (w < 1e-14) continue;
                for (int k = 0; k < n[0]; k++)
                    row[k] += w * sx[k];
            }
    }
    for (int c = 0; c < m->n_cells; c++)
        field[c] /= m->V[c];
    free(s);
}

static double seconds(void)
{
    struct timespec t;

    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* The particles seen through one way; the shortest of three times [s]. */
static struct averaging *prepare(const struct way *way, const struct mesh *m,
                                 const struct particles *ps)
{
    struct averaging_options o = way->o;

    o.fields = 1;
    if (way->cells > 0.0) o.bandwidth = way->cells * cbrt(m->V[0]);
    return averaging_create(averaging_method_named(way->method), m, ps, &o);
}

/* q: volumes, of which a cap may leave some out. */
static double average(struct averaging *a, const double *q, double *field)
{
    const int n_particles = averaging_cells(a)->ps->n;
    double *const counted = alloc_doubles(n_particles);
    double shortest = INFINITY;

    for (int n = 0; n < 3; n++) {
        const double begin = seconds();
        if (averaging_bind(a) != 0) exit(1);
        for (int i = 0; i < n_particles; i++)
            counted[i] = q[i];
        averaging_apply_cap(a, 1, counted);
        averaging_spread(a, 1, counted, field);
        shortest = fmin(shortest, seconds() - begin);
    }
    free(counted);
    return shortest;
}

/* A row of the table. */
static void compare(const struct way *way, double dx, const struct mesh *m,
                    const struct particles *ps, const double *q,
                    const double *truth, double *field)
{
    struct averaging *const a = prepare(way, m, ps);
    const double time = average(a, q, field);
    const struct averaging_report *const r = averaging_report(a);
    double error = 0.0, all = 0.0, full = 0.0;

    for (int c = 0; c < m->n_cells; c++) {
        error += m->V[c] * fabs(field[c] - truth[c]);
        all += m->V[c] * truth[c];
        full += field[c] > 0.74;
    }
    printf("%-4.3g %-18s %9.6f %7.3f %7.2f %7.2f %9.2f\n", dx, way->name,
           error / all, r->highest, 100.0 * r->negative,
           100.0 * full / m->n_cells, 1e3 * time);
    averaging_free(a);
}

static const double meshes[] = {6.0, 4.0, 3.0, 2.0, 1.5, 1.0, 0.5};
enum { MESHES = sizeof meshes / sizeof *meshes };

static double *volumes(const struct particles *ps)
{
    double *const q = alloc_doubles(ps->n);

    for (int i = 0; i < ps->n; i++)
        q[i] = M_PI / 6.0;
    return q;
}

static void table(const char *layout)
{
    double L[3];
    struct particles *const ps = strcmp(layout, "bed") == 0 ? bed(L) : slot(L);
    double *const q = volumes(ps);

    printf("# %d particles; dx [d], method, error [-], highest eps_s [-], "
           "negative [%%], cells above 0.74 [%%], time [ms]\n",
           ps->n);
    for (int k = 0; k < MESHES; k++) {
        struct mesh *const m = mesh_of(L, meshes[k], 0);
        double *const truth = alloc_doubles(m->n_cells);
        double *const field = alloc_doubles(m->n_cells);
        exact(m, ps, truth);
        for (int w = 0; w < WAYS; w++)
            if (meshes[k] >= ways[w].finest)
                compare(&ways[w], meshes[k], m, ps, q, truth, field);
        free(truth);
        free(field);
        mesh_free(m);
    }
    free(q);
    particles_free(ps);
}

/* Cells of a layer in the middle, through spheres, by all pictured ways on
 * three meshes, for gnuplot: an index a mesh. Columns: x y dx, exact, then the
 * ways. */
static void picture(const char *layout)
{
    double L[3];
    struct particles *const ps = strcmp(layout, "bed") == 0 ? bed(L) : slot(L);
    double *const q = volumes(ps);

    static const int shown[] = {1, 3, 6};

    for (int row = 0; row < 3; row++) {
        const int k = shown[row];
        struct mesh *const m = mesh_of(L, meshes[k], 0);
        double *const f = alloc_doubles((WAYS + 1) * m->n_cells);
        int n = 1;
        exact(m, ps, f);
        printf("# dx %g: x y dx, exact", meshes[k]);
        for (int w = 0; w < WAYS; w++) {
            if (!ways[w].pictured) continue;
            struct averaging *const a = prepare(&ways[w], m, ps);
            average(a, q, &f[n++ * m->n_cells]);
            averaging_free(a);
            printf(", %s", ways[w].name);
        }
        printf("\n");
        const int layer = m->box.n[0] * m->box.n[1];
        const int first = (int)(0.495 * m->box.n[2]) * layer;
        for (int c = first; c < first + layer; c++) {
            printf("%.3f %.3f %.3f", m->centre[3 * c], m->centre[3 * c + 1],
                   L[0] / m->box.n[0]);
            for (int e = 0; e < n; e++)
                printf(" %.3f", f[e * m->n_cells + c]);
            printf("\n");
        }
        printf("\n\n");
        free(f);
        mesh_free(m);
    }
    free(q);
    particles_free(ps);
}

/* Spheres in a ball of radius 9 d with a hole, moved and turned about the
 * middle of a box of 36 d. */
static struct particles *ball(double angle, double shift)
{
    struct particles *const ps = particles_create(6000);
    uint64_t seed = 11;

    for (int e = 0; e < 17 * 17 * 17; e++) {
        double x[3] = {e % 17 - 8.0, e / 17 % 17 - 8.0, e / 289 - 8.0};
        for (int k = 0; k < 3; k++)
            x[k] = 1.06 * x[k] + 0.06 * (random_number(&seed) - 0.5);
        const double r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (r > 9.0 || hypot(x[0] - 3.0, x[1]) < 3.0) continue;
        place(ps, 18.0 + shift + x[0] * cos(angle) - x[1] * sin(angle),
              18.0 + 0.7 * shift + x[0] * sin(angle) + x[1] * cos(angle),
              18.0 + 0.4 * shift + x[2]);
    }
    return ps;
}

/* What each particle sees of eps_s. */
static void seen(const struct way *way, const struct mesh *m,
                 const struct particles *ps, const char *interpolation,
                 double *to)
{
    double *const q = volumes(ps), *const field = alloc_doubles(m->n_cells);
    struct averaging *const a = prepare(way, m, ps);

    if (averaging_bind(a) != 0) exit(1);
    averaging_spread(a, 1, q, field);
    interpolation_named(interpolation)->apply(a, 1, field, NULL, to);
    averaging_free(a);
    free(q);
    free(field);
}

/* Root mean square of the change, over the mean. */
static double change(int n, const double *a, const double *b)
{
    double square = 0.0, mean = 0.0;

    for (int i = 0; i < n; i++) {
        square += gsl_pow_2(a[i] - b[i]) / n;
        mean += a[i] / n;
    }
    return sqrt(square) / mean;
}

/* The mesh moved by shares of a cell, and turned by 30 degrees, under the same
 * particles: how much of what they see changes. */
static void turn(void)
{
    const double L[3] = {36.0, 36.0, 36.0};
    static const int some[] = {0, 2, 3, 4, 5, 7, 8, 11};

    printf("# dx [d], method, seen at the host: moved, turned; by linear "
           "interpolation: moved, turned [-]\n");
    for (int k = 2; k < 6; k += k == 3 ? 2 : 1) {
        struct mesh *const m = mesh_of(L, meshes[k], 0);
        struct particles *const ps = ball(0.0, 0.0);
        struct particles *const moved = ball(0.0, 0.5 * meshes[k]);
        struct particles *const turned = ball(M_PI / 6.0, 0.0);
        double *const s = alloc_doubles(3 * ps->n);
        for (int w = 0; w < 8; w++) {
            printf("%-4.3g %-18s", meshes[k], ways[some[w]].name);
            for (int i = 0; i < 2; i++) {
                const char *const by = i == 0 ? "nearest" : "linear";
                seen(&ways[some[w]], m, ps, by, s);
                seen(&ways[some[w]], m, moved, by, s + ps->n);
                seen(&ways[some[w]], m, turned, by, s + 2 * ps->n);
                printf(" %7.4f %7.4f", change(ps->n, s, s + ps->n),
                       change(ps->n, s, s + 2 * ps->n));
            }
            printf("\n");
        }
        free(s);
        particles_free(ps);
        particles_free(moved);
        particles_free(turned);
        mesh_free(m);
    }
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "table") == 0)
        table(argv[2]);
    else if (argc == 3 && strcmp(argv[1], "picture") == 0)
        picture(argv[2]);
    else if (argc == 2 && strcmp(argv[1], "turn") == 0)
        turn();
    else
        return 2;
    return 0;
}
