/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 16-liggghts.c -- four spheres beside the same ones in LIGGGHTS (the deck is
 * figures/16/16-liggghts.in): place and velocity of ours, of theirs, every 5 ms,
 * one block a sphere; then the largest differences. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "dem/dem.h"

enum { SPHERES = 4, SAMPLES = 61, STEPS = 1000 };

static const double start[SPHERES][3] = {{0.03, 0.011, 0.048},
                                         {0.08, 0.005, 0.05},
                                         {0.092, 0.005, 0.0505},
                                         {0.105, 0.005, 0.051}};

/* x y z, v, omega */
typedef double state[SAMPLES][SPHERES][9];

static void read_theirs(state s)
{
    FILE *const f = fopen("figures/data/liggghts-spheres.txt", "r");
    int id;

    if (f == NULL || fscanf(f, "%*[^\n] %*[^\n]") != 0) exit(1);
    for (int t = 0; t < SAMPLES; t++)
        for (int i = 0; i < SPHERES; i++) {
            double *const r = s[t][i];
            if (fscanf(f, "%d %lf %lf %lf %lf %lf %lf %lf %lf %lf", &id, &r[0],
                       &r[1], &r[2], &r[3], &r[4], &r[5], &r[6], &r[7],
                       &r[8]) != 10)
                exit(1);
        }
    fclose(f);
}

static void look(const struct particles *ps, double to[SPHERES][9])
{
    for (int i = 0; i < ps->n; i++) {
        const double now[9] = {ps->x[i],  ps->y[i],  ps->z[i],
                               ps->vx[i], ps->vy[i], ps->vz[i],
                               ps->wx[i], ps->wy[i], ps->wz[i]};
        for (int k = 0; k < 9; k++)
            to[ps->id[i]][k] = now[k];
    }
}

static void run_ours(state s)
{
    const struct dem_options o = {.law = contact_law_named("hertz"),
                                  .material = {.young = 1e7,
                                               .poisson = 0.3,
                                               .restitution = 0.8,
                                               .friction = 0.3},
                                  .step = 5e-6,
                                  .hi = {0.2, 0.1, 0.1}};
    struct particles *const ps = particles_create(SPHERES);
    struct dem_report r;

    for (int i = 0; i < SPHERES; i++) {
        particles_add(ps, start[i], 0.01, 2500.0);
        ps->ey[i] = -9.81 * ps->m[i];
    }
    ps->vx[0] = 0.8;
    ps->vz[0] = 0.02;
    struct dem *const dem = dem_create(ps, &o);
    for (int t = 0; t < SAMPLES; t++) {
        if (t > 0 && dem_run(dem, STEPS, &r) != 0) exit(1);
        look(ps, s[t]);
    }
    dem_free(dem);
    particles_free(ps);
}

/* Largest distance in three numbers from k on, sphere by sphere [m, m/s]. */
static double apart(state a, state b, int k)
{
    double most = 0.0;

    for (int t = 0; t < SAMPLES; t++)
        for (int i = 0; i < SPHERES; i++) {
            const double *const p = a[t][i] + k, *const q = b[t][i] + k;
            const double d2 = (p[0] - q[0]) * (p[0] - q[0]) +
                              (p[1] - q[1]) * (p[1] - q[1]) +
                              (p[2] - q[2]) * (p[2] - q[2]);
            most = d2 > most ? d2 : most;
        }
    return sqrt(most);
}

int main(void)
{
    static state ours, theirs;

    read_theirs(theirs);
    run_ours(ours);
    for (int i = 0; i < SPHERES; i++) {
        printf(
            "%s# sphere %d: t [s], ours x z [m], v_x [m/s], theirs x z v_x\n",
            i > 0 ? "\n\n" : "", i + 1);
        for (int t = 0; t < SAMPLES; t += 3) {
            const double *const a = ours[t][i], *const b = theirs[t][i];
            printf("%.3f %.6f %.6f %8.5f  %.6f %.6f %8.5f\n", 5e-3 * t, a[0],
                   a[2], a[3], b[0], b[2], b[3]);
        }
    }
    printf("\n\n# apart\nplaces = %.3f um\nvelocities = %.3f mm/s\nspins = "
           "%.3f rad/s\n",
           1e6 * apart(ours, theirs, 0), 1e3 * apart(ours, theirs, 3),
           apart(ours, theirs, 6));
    return 0;
}
