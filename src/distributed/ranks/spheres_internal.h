/* spheres_internal.h -- what the files of spheres.h share.
 * Chapter "Past one machine". */
#ifndef DISTRIBUTED_RANKS_SPHERES_INTERNAL_H
#define DISTRIBUTED_RANKS_SPHERES_INTERNAL_H

#include "distributed/ranks/spheres.h"

enum { SPHERES_KEPT = 64 };

struct spheres {
    void *lammps;
    struct dem *dem;           /* borrowed */
    const struct partition *p; /* borrowed */
    struct words w;
    MPI_Comm comm;
    int loaded; /* [-] 1: from a file */
    int n_kept; /* [-] arrays that travel in the property */
    double *kept[SPHERES_KEPT];
    int kept_width[SPHERES_KEPT];
    int width;        /* [-] numbers a sphere in it */
    long all, id_sum; /* of all ranks */
    int n_before;     /* [-] before the last run: number, ids, centres */
    int *id_before;
    double *x_before; /* [m] 3 a sphere */
};

/* Tells LAMMPS one line. */
void spheres_tell(const struct spheres *q, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Contacts, walls and motion; and how they end. */
void spheres_equip(struct spheres *q, const struct words *w);
void spheres_strip(struct spheres *q);

/* An array of rows of LAMMPS, by its name, and the number of its rows. */
double **spheres_rows(const struct spheres *q, const char *name);
int spheres_count(const struct spheres *q);

/* spheres_report.c: sums and maxima over the ranks. A sphere is lost if LAMMPS
 * has it no more, or outside the cells of its rank, or if there was no room to
 * take it. */
void spheres_report(struct spheres *q, int untaken, struct dem_report *r);

#endif
