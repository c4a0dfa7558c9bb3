/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bed.h -- the beds that `dem bed` writes, as data files of LAMMPS. */
#ifndef BENCH_BED_H
#define BENCH_BED_H

#include <stdio.h>
#include <stdlib.h>

#include "dem/particles.h"

static inline void give_up(const char *path)
{
    fprintf(stderr, "%s: not a bed that `dem bed` wrote\n", path);
    exit(1);
}

/* hi [m] becomes the upper corner; the lower one is the origin. */
static inline struct particles *read_bed(const char *path, double hi[3])
{
    FILE *const f = fopen(path, "r");
    int n = 0, id;

    if (f == NULL ||
        fscanf(f,
               "bed %d atoms 1 atom types 0 %lf xlo xhi 0 %lf ylo yhi 0 %lf "
               "zlo zhi Atoms",
               &n, &hi[0], &hi[1], &hi[2]) != 4)
        give_up(path);
    struct particles *const ps = particles_create(n);
    for (int i = 0; i < n; i++) {
        double x[3], d, rho;
        if (fscanf(f, "%d 1 %lf %lf %lf %lf %lf", &id, &d, &rho, &x[0], &x[1],
                   &x[2]) != 6)
            give_up(path);
        particles_add(ps, x, d, rho);
    }
    if (fscanf(f, " Velocities%n", &id) != 0) give_up(path);
    for (int i = 0; i < n; i++)
        if (fscanf(f, "%d %lf %lf %lf 0 0 0", &id, &ps->vx[i], &ps->vy[i],
                   &ps->vz[i]) != 4)
            give_up(path);
    fclose(f);
    return ps;
}

#endif
