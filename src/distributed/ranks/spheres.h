/* spheres.h -- LAMMPS moves the particles.  Chapter "Past one machine".
 *
 * A method of dem.h for the particles of a rank: it has the spheres that LAMMPS
 * has there, and what is attached to them travels in a property of LAMMPS'
 * atoms. No rank ever has all of them. All functions are called by all ranks
 * together.
 */
#ifndef DISTRIBUTED_RANKS_SPHERES_H
#define DISTRIBUTED_RANKS_SPHERES_H

#include "distributed/words.h"
#include "dem/bed.h"
#include "dem/dem_method.h"
#include "distributed/ranks/partition.h"

#include <mpi.h>

extern const struct dem_method spheres_method;

struct spheres;

/* One that is added. */
struct sphere {
    int id, type;                  /* [-] type: number of the material plus 1 */
    double x[3], v[3], w[3], d, m; /* [m], [m/s], [rad/s], [m], [kg] */
};

/* LAMMPS with an empty box, cut as the partition is, or with the spheres of a
 * file that only the first rank need be able to read. */
struct spheres *spheres_create(const struct partition *p, const struct words *w,
                               const char *file, MPI_Comm comm);
void spheres_free(struct spheres *q);

/* Each rank offers spheres; the one in whose part of the box a sphere lies
 * keeps it. Once, by all ranks together. */
void spheres_add(struct spheres *q, int n, const struct sphere *s);

/* Lets them come to rest under gravity (spheres_settle.c), in steps of `step`
 * [s]. */
void spheres_settle(struct spheres *q, const struct words *w, double step,
                    const struct bed_options *bed, struct bed_report *r);

/* Sums of all ranks: their number and mean diameter [m]; `each` is added to the
 * slab of cells in which a sphere lies, in each direction. */
long spheres_all(const struct spheres *q, double *mean_diameter);
void spheres_weigh(const struct spheres *q, double each, double *weight[3]);

/* How many will be on this rank once the partition has its final planes. */
int spheres_share(const struct spheres *q);

/* Starts the run with those planes: the spheres of this rank are the particles
 * of dem, whose state this becomes, and what is attached to them is kept. */
void spheres_begin(struct spheres *q, struct dem *dem, const struct words *w);

/* Writes the file, without disturbing the run. */
void spheres_save(struct spheres *q, const char *file);

/* Spheres that are on another rank than that which first had them [-], of all
 * ranks. */
long spheres_moved(const struct spheres *q);

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

/* An array of rows of LAMMPS, by its name, and the number of its rows. */
double **spheres_rows(const struct spheres *q, const char *name);
int spheres_count(const struct spheres *q);

/* spheres_report.c: sums and maxima over the ranks. A sphere is lost if LAMMPS
 * has it no more, or outside the cells of its rank, or if there was no room to
 * take it. */
void spheres_report(struct spheres *q, int untaken, struct dem_report *r);

#endif
