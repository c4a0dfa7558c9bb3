/* stencil.h -- for each cell, the cells near it.
 * Chapter "Averaging".
 *
 * Near means: some point of the cell is closer than b to the centre of the
 * other cell, or to some point of it. The stencils are found once, by a walk
 * from cell to cell that adds up the link vectors, so graded meshes and
 * periodic directions need no special treatment: across a period the same cells
 * occur again, at another distance. A cell can therefore occur more than once
 * in a stencil, as several periodic images.
 *
 * A stencil is stored as differences of cell numbers and of centres. Cells with
 * equal surroundings (on a uniform mesh all but those near the walls) have a
 * common stencil, which reduces the memory a hundredfold and makes the kernel
 * method fast.
 */
#ifndef AVERAGING_KERNEL_STENCIL_H
#define AVERAGING_KERNEL_STENCIL_H

#include "mesh/mesh.h"

struct stencil {
    int n_shapes;
    int *shape; /* [-] n_cells; which one a cell has */
    int *start; /* [-] n_shapes + 1; the entries of shape s are start[s] ... */
    int *index_offset; /* [-] cell number of the entry less that of the cell */
    double *dx, *dy, *dz; /* [m] from the cell's centre to the entry's */
    int largest;          /* [-] entries of the largest shape */
};

/* Which part of the other cell must be nearer than b: its centre, or any point.
 */
enum stencil_to { STENCIL_TO_CENTRE, STENCIL_TO_CELL };

/* The first entry of each is the cell itself. The extent of a cell that is not
 * a box is that of its bounding box, which may be too large but never too
 * small. */
struct stencil *stencil_create(const struct mesh *m, double b /* [m] */,
                               enum stencil_to to);
void stencil_free(struct stencil *s);

/* Estimate of the memory of a stencil before it is created [byte]; 0 for a box
 * of equal cells, in which nearly all cells have a common stencil. */
double stencil_bytes(const struct mesh *m, double b, enum stencil_to to);

/* Half extents of every cell from its centre [m], 3 a cell; released with
 * free(). */
double *stencil_extents(const struct mesh *m);

#endif
