/* halo.h -- carries cells between ranks.  Chapter "Past one machine".
 *
 * Every cell has one owner; the other ranks that have it in their layers have
 * copies. All functions are called by all ranks together.
 */
#ifndef DISTRIBUTED_RANKS_HALO_H
#define DISTRIBUTED_RANKS_HALO_H

#include "distributed/ranks/partition.h"

#include <mpi.h>

struct halo; /* PETSc's star forest */

struct halo *halo_create(const struct partition *p, MPI_Comm comm);
void halo_free(struct halo *h);

/* m fields side by side: the owners' values to all copies; and the copies'
 * added to the owners'. */
void halo_refresh(struct halo *h, int m, double *field);
void halo_add(struct halo *h, int m, double *field);

/* The flux, or any number, of the faces around each cell of the layers, as its
 * owner has it. */
void halo_refresh_faces(struct halo *h, const struct face_places *places,
                        double *face);

/* 1 if the cell is this rank's own, 0 if it is a copy. */
const unsigned char *halo_own(const struct halo *h);

double halo_largest(const struct halo *h, double x);
void halo_sum(const struct halo *h, int n, double *x);

#endif
