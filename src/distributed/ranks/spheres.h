/* spheres.h -- LAMMPS moves the particles.  Chapter "Past one machine".
 *
 * A method of dem.h for the particles of a rank: it has the spheres that LAMMPS
 * has there, and what is attached to them travels in a property of LAMMPS'
 * atoms. All functions are called by all ranks together.
 */
#ifndef DISTRIBUTED_RANKS_SPHERES_H
#define DISTRIBUTED_RANKS_SPHERES_H

#include "dem/dem_method.h"
#include "distributed/ranks/partition.h"
#include "distributed/words.h"

#include <mpi.h>

extern const struct dem_method spheres_method;

struct spheres;

/* Opens LAMMPS for the particles of dem, whose state this becomes. */
struct spheres *spheres_create(struct dem *dem, const struct partition *p,
                               const struct words *w, MPI_Comm comm);

/* The spheres come from the first rank's `all` (elsewhere NULL), or from a file
 * of LAMMPS that only the first rank need be able to read. */
void spheres_place(struct spheres *q, const struct particles *all);
void spheres_load(struct spheres *q, const char *file);

/* Writes that file, without disturbing the run. */
void spheres_save(struct spheres *q, const char *file);

/* Spheres that are on another rank than that which first had them [-], of all
 * ranks. */
long spheres_moved(const struct spheres *q);

#endif
