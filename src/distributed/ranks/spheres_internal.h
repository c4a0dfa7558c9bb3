/* spheres_internal.h -- what the files of spheres.h share.
 * Chapter "Past one machine". */
#ifndef DISTRIBUTED_RANKS_SPHERES_INTERNAL_H
#define DISTRIBUTED_RANKS_SPHERES_INTERNAL_H

#include "distributed/ranks/arrays.h"
#include "distributed/ranks/spheres.h"

struct spheres {
    void *lammps;
    struct dem *dem;           /* borrowed */
    const struct partition *p; /* borrowed */
    struct words w;
    MPI_Comm comm;
    struct arrays kept; /* those that travel in the property */
    int width;          /* [-] numbers a sphere in it */
    long all, id_sum;   /* of all ranks */
};

/* An array of rows of LAMMPS, by its name, and the number of its rows. */
double **spheres_rows(const struct spheres *q, const char *name);
int spheres_count(const struct spheres *q);

/* spheres_report.c: sums and maxima over the ranks. A sphere is lost if LAMMPS
 * has it no more, or outside the cells of its rank, or if there was no room to
 * take it. */
void spheres_report(struct spheres *q, int untaken, struct dem_report *r);

#endif
