/* contiguous_faces.h -- contiguous ranges of faces between contiguous ranges of
 * cells.
 * Chapter "Linear solvers".
 *
 * Between a row of cells and the next row of a box, face f + 1 joins the cells
 * after those that face f joins. A loop over such a range needs no list of
 * owners and neighbours: it reads and writes contiguous memory, eight numbers
 * at a time (measured: three to five times faster). Where most ranges have one
 * face, as in a mesh with shuffled numbers, loops use the lists.
 */
#ifndef LINEAR_FAST_CONTIGUOUS_FACES_H
#define LINEAR_FAST_CONTIGUOUS_FACES_H

#include "linear/faces.h"

enum {
    CONTIGUOUS_FACES_GROUPS = 16,   /* at most */
    CONTIGUOUS_FACES_MIN_LENGTH = 8 /* faces in a range, on average */
};

struct contiguous_range {
    int face, owner, n; /* the first face, its owner, how many */
};

struct contiguous_faces {
    struct face_pieces pieces; /* its functions; the first member */
    int n_groups;
    struct {
        int first,
            end; /* its contiguous ranges, with ascending faces and owners */
        int distance; /* from owner to neighbour */
        int boundary; /* 1: no neighbours */
    } group[CONTIGUOUS_FACES_GROUPS];
    struct contiguous_range *range;
};

/* Finds the ranges of the n_inner faces that have neighbours and of the
 * boundary faces after them; NULL if the ranges are too short on average. */
struct face_pieces *contiguous_faces_find(int n_inner, int n, const int *owner,
                                          const int *neighbour);

#endif
