/* partition.h -- which cells of a box belong to which rank.
 * Chapter "Past one machine".
 *
 * The box is cut by planes into P[0] P[1] P[2] smaller ones; rank r has its own
 * cells and `layers` layers of its neighbours' around them, as a mesh of its
 * own, which has slip walls where it is cut off. Across a periodic end the
 * layers are those of the other end.
 */
#ifndef DISTRIBUTED_RANKS_PARTITION_H
#define DISTRIBUTED_RANKS_PARTITION_H

#include "mesh/mesh.h"

#include <mpi.h>

/* In cells; a direction that is not cut has no layers. */
struct extent {
    int first[3], own[3]; /* own cells: from first on */
    int at[3], n[3];      /* with the layers; at may be negative */
};

struct partition {
    int rank, size, layers;
    int P[3];        /* [-] parts in each direction */
    int N[3];        /* [-] cells of the whole box */
    int periodic[3]; /* [-] */
    double size_m[3];
    int *cut[3]; /* [-] P + 1 planes, counted in cells */
    struct extent here;
};

/* How the box is cut: P parts, or where these are 0 as many as there are ranks,
 * across `down` first, the direction of gravity, last. weight[k] [-] is what
 * each slab of cells of direction k costs. 0, or 2 after a message. */
int partition_init(struct partition *p, const struct box_spec *box,
                   const int P[3], int down, int rank, int size, int layers);
void partition_cut(struct partition *p, const double *const weight[3]);
void partition_release(struct partition *p);

/* Cells of the whole box [-]. */
double partition_cells(const struct partition *p);

/* The cells of a rank. */
struct extent partition_extent(const struct partition *p, int rank);

/* The number of a cell of the whole box, and the rank that owns it, from its
 * place in the extent e; local: its number in the mesh of that rank. */
int partition_whole(const struct partition *p, const struct extent *e,
                    int cell);
int partition_owner(const struct partition *p, int whole, int *local);

/* The rank that owns the cell i, j, k of the whole box. */
int partition_rank(const struct partition *p, const int i[3]);

/* 1 if the cell of the extent is its own. */
int partition_is_own(const struct extent *e, int cell);

/* The mesh of this rank, where it stands in the box; cut[i] tells of patch i
 * whether it is cut off there. */
struct mesh *partition_mesh(const struct partition *p, int cut[6]);

/* Of each cell the face above and below it in each direction, 3 a cell; -1
 * where that is another cell's, or is cut off. */
struct face_places {
    int *up, *down;
};
struct face_places partition_faces(const struct mesh *m, const int cut[6]);

/* Carries cells between ranks.
 *
 * Every cell has one owner; the other ranks that have it in their layers have
 * copies. All functions are called by all ranks together. */

struct halo; /* PETSc's star forest */

/* What PETSc cannot do here is a bug or a lack of memory: ends all ranks. */
void halo_must(int error);

struct halo *halo_create(const struct partition *p, MPI_Comm comm);
void halo_free(struct halo *h);

/* Copies the values of the owners to all copies, of m fields side by side. */
void halo_refresh(struct halo *h, int m, double *field);
/* Adds the values of the copies to those of the owners. */
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
