/* part.h -- the simulation of a rank.
 * Chapter "Past one machine".
 *
 * The part is a simulation like any other one: sub-mesh, fluid, coupling and
 * effects are those of one machine. Three things are done by all ranks
 * together, through hooks: the two linear solves (solve.h), the motion of the
 * particles (spheres.h), the averaging (smoothing.h). No rank has the whole.
 */
#ifndef DISTRIBUTED_RANKS_PART_H
#define DISTRIBUTED_RANKS_PART_H

#include "case/settings.h"
#include "distributed/ranks/smoothing.h"
#include "distributed/ranks/solve.h"
#include "distributed/ranks/spheres.h"

struct part {
    MPI_Comm comm;
    struct partition p;
    struct simulation *sim;
    struct halo *halo;
    struct face_places places;
    struct solve *solve;
    struct spheres *spheres;
    struct smoothing smoothing;
    double *V; /* [m^3] of the cells; 0 of copies */
    double *own_V, *own_S, *no_residual,
        ends[6]; /* what part_count_own exchanges */
};

/* The partition that a case asks for; 0, or 2 after a message. */
int part_divide(const struct settings *s, MPI_Comm comm, struct partition *p);

/* Builds the part: places and settles the spheres, or reads them from a file of
 * LAMMPS, and then divides cells and spheres. With the exit code, after a
 * message of some rank. */
struct part *part_create(const struct settings *s, MPI_Comm comm,
                         const char *file, int *code);
void part_free(struct part *part); /* but not its simulation */

/* For sums over the whole: only own cells have a volume, from now to the next
 * call. */
void part_count_own(struct part *part);

#endif
