/* part.h -- the simulation of a rank, and its way to and from the record.
 * Chapter "Past one machine".
 *
 * The part is a simulation like any other one: sub-mesh, fluid, coupling and
 * effects are those of one machine. Three things are done by all ranks
 * together, through hooks: the two linear solves (solve.h), the motion of the
 * particles (spheres.h), the averaging (smoothing.h). The record is the whole
 * simulation, on the first rank.
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
    double exchange_residual; /* [-] of the last step, of all ranks */
};

/* The partition that a case asks for; 0, or 2 after a message. */
int part_divide(const struct settings *s, MPI_Comm comm, struct partition *p);

/* Builds the part; record is the whole simulation on the first rank, elsewhere
 * NULL. NULL, with the exit code, after a message of some rank. */
struct part *part_create(const struct settings *s, MPI_Comm comm,
                         const struct simulation *record, int *code);
void part_free(struct part *part);

/* pieces.c: fields and particles of all parts to the record; the fields of the
 * record to all parts. Only the arrays of the list, or NULL: all. */
void part_collect(struct part *part, struct simulation *record,
                  const char *list);
void part_spread(struct part *part, struct simulation *record);

#endif
