/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bed that tests/bench/dem.sh times, and our run of it.
 *
 *   dem bed LAW FILE TILES THROW    writes TILES x TILES settled beds of 9240
 *                                   spheres of 1.2 mm side by side, as a data
 *                                   file of LAMMPS and LIGGGHTS; with random
 *                                   velocities of up to THROW m/s in each
 *                                   direction
 *   dem run LAW FILE STEPS          reads it and makes so many steps
 *
 * The bed is that of [SX15 Table 1] with a hundred times its Young's modulus,
 * as LIGGGHTS refuses less than 5 MPa; or with springs of 1000 N/m.
 */
#include <gsl/gsl_math.h>
#include <gsl/gsl_rng.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "bed.h"
#include "case/resume/resume.h"

/* Of several beds the highest spheres are left out: 6 x 6 hold 331 776. */
enum { COUNT = 9240, OF_MANY = 9216, STEPS_A_RUN = 100 };

static const double size[3] = {0.044, 0.12, 0.01}; /* [m] of one bed */
static const double diameter = 1.2e-3;             /* [m] */
static const double density = 1000.0;              /* [kg/m^3] */
static const double g = 9.81;                      /* [m/s^2] */

static struct dem_options options(const char *law, const double hi[3])
{
    return (struct dem_options){.law = contact_law_named(law),
                                .material = {.young = 1.2e7,
                                             .poisson = 0.33,
                                             .stiffness = 1000.0,
                                             .restitution = 0.98,
                                             .friction = 0.1},
                                .step = 4e-6,
                                .skin = 0.2e-3,
                                .hi = {hi[0], hi[1], hi[2]}};
}

/* One settled bed; kept beside `path`, which names a folder, as it takes half a
 * minute. */
static struct particles *settled(const char *law, const char *path)
{
    const struct bed_options bed = {.count = COUNT,
                                    .diameter = diameter,
                                    .density = density,
                                    .seed = 1,
                                    .jitter = 0.5,
                                    .gravity = {0.0, -g, 0.0},
                                    .settle = 1.0};
    const struct dem_options o = options(law, size);
    struct particles *const ps = particles_create(COUNT);
    struct dem *const dem = dem_create(ps, &o);
    struct bed_report r;
    char name[4096];

    snprintf(name, sizeof name, "%.*s/%s.settled",
             (int)(strrchr(path, '/') - path), path, law);
    struct input in = input_of(name);
    if (bed_cache_create(&in, ps, dem, &bed, &o, &r) != BED_CREATED ||
        !r.settled)
        exit(1);
    input_release(&in);
    dem_free(dem);
    return ps;
}

static int ascending(const void *a, const void *b)
{
    const double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

/* [m] that just `count` centres are not above. */
static double height_of(const struct particles *ps, int count)
{
    double *const y = alloc_doubles(ps->n);

    memcpy(y, ps->y, (size_t)ps->n * sizeof *y);
    qsort(y, (size_t)ps->n, sizeof *y, ascending);
    const double height = y[count - 1];
    free(y);
    return height;
}

/* Every other bed is a mirror image, so that who leans on a wall leans on his
 * image. */
static double tiled(double x, double length, int tile)
{
    return tile * length + (tile % 2 ? length - x : x);
}

static void write_tile(FILE *f, const struct particles *ps, double height,
                       int across, int along, int *id)
{
    for (int i = 0; i < ps->n; i++)
        if (ps->y[i] <= height)
            fprintf(f, "%d 1 %.9g %g %.12g %.12g %.12g\n", ++*id, diameter,
                    density, tiled(ps->x[i], size[0], across), ps->y[i],
                    tiled(ps->z[i], size[2], along));
}

static void write_velocities(FILE *f, int n, double throw)
{
    gsl_rng *const random = gsl_rng_alloc(gsl_rng_mt19937);

    fprintf(f, "\nVelocities\n\n");
    for (int i = 0; i < n; i++) {
        fprintf(f, "%d", i + 1);
        for (int k = 0; k < 3; k++)
            fprintf(f, " %.9g", throw *(2.0 * gsl_rng_uniform(random) - 1.0));
        fprintf(f, " 0 0 0\n");
    }
    gsl_rng_free(random);
}

static int write_bed(const char *law, const char *path, int tiles, double throw)
{
    struct particles *const ps = settled(law, path);
    const int one = tiles > 1 ? OF_MANY : COUNT, n = one * tiles * tiles;
    FILE *const f = fopen(path, "w");
    int id = 0;

    if (f == NULL) return 1;
    fprintf(f, "bed\n\n%d atoms\n1 atom types\n\n", n);
    fprintf(f, "0 %.9g xlo xhi\n0 %.9g ylo yhi\n0 %.9g zlo zhi\n\nAtoms\n\n",
            tiles * size[0], size[1], tiles * size[2]);
    for (int across = 0; across < tiles; across++)
        for (int along = 0; along < tiles; along++)
            write_tile(f, ps, height_of(ps, one), across, along, &id);
    write_velocities(f, n, throw);
    particles_free(ps);
    return fclose(f) != 0;
}

/* What must come out alike of all programs. */
static void describe(struct dem *dem, const struct particles *ps)
{
    int n, pairs = 0;
    struct dem_history *const spring = dem_histories(dem, &n);
    double height = 0.0, v2 = 0.0;

    for (int q = 0; q < n; q++)
        pairs += spring[q].other >= 0;
    for (int i = 0; i < ps->n; i++) {
        height += ps->y[i];
        v2 += ps->vx[i] * ps->vx[i] + ps->vy[i] * ps->vy[i] +
              ps->vz[i] * ps->vz[i];
    }
    printf("%d %.3f %.4f %.3g\n", ps->n, 2.0 * pairs / ps->n,
           1e3 * height / ps->n, sqrt(v2 / ps->n));
    free(spring);
}

static int run(const char *law, const char *path, int steps)
{
    double hi[3];
    struct particles *const ps = read_bed(path, hi);
    const struct dem_options o = options(law, hi);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    for (int i = 0; i < ps->n; i++)
        ps->ey[i] = -g * ps->m[i];
    for (int left = steps; left > 0; left -= STEPS_A_RUN)
        if (dem_run(dem, left < STEPS_A_RUN ? left : STEPS_A_RUN, &r) != 0)
            return 1;
    describe(dem, ps);
    dem_free(dem);
    particles_free(ps);
    return 0;
}

int main(int argc, char **argv)
{
    const char *const law = argc > 2 ? argv[2] : "";

    if (contact_law_named(law) != NULL) {
        if (argc == 6 && strcmp(argv[1], "bed") == 0)
            return write_bed(law, argv[3], atoi(argv[4]), atof(argv[5]));
        if (argc == 5 && strcmp(argv[1], "run") == 0)
            return run(law, argv[3], atoi(argv[4]));
    }
    fprintf(stderr, "dem bed LAW FILE TILES THROW | dem run LAW FILE STEPS\n");
    return 2;
}
