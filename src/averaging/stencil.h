/* stencil.h -- for each cell, the cells near it.  Chapter 8.
 *
 * Near means: some point of the host cell is closer than b to the other's
 * centre, or to some point of the other. Found once, by walking from face to
 * face and adding up the links, so graded meshes and periodic directions need
 * nothing special: behind a period one meets the same cells again, at another
 * distance. A cell can therefore occur more than once in a stencil, as several
 * images of itself.
 *
 * A stencil is kept as differences of cell numbers and of centres. Hosts that
 * look alike (on an equal mesh: all but those near the walls) share one, which
 * saves a hundredfold in memory and is what makes the kernel method fast.
 */
#ifndef STENCIL_H
#define STENCIL_H

#include "mesh/mesh.h"

struct stencil {
    int n_shapes;
    int *shape; /* [-] n_cells; which one a host has */
    int *start; /* [-] n_shapes + 1; the entries of shape s are start[s] ... */
    int *step;  /* [-] cell number of the entry less that of the host */
    double *dx, *dy, *dz; /* [m] from the host's centre to the entry's */
    int largest;          /* [-] entries of the largest shape */
};

/* What must be nearer than b: the centre of the other cell or any of it. */
enum stencil_to { STENCIL_TO_CENTRE, STENCIL_TO_CELL };

/* The first entry of each is the host itself. A cell that is no box reaches as
 * far as the box around its corners; that can be too much, never too little. */
struct stencil *stencil_create(const struct mesh *m, double b /* [m] */,
                               enum stencil_to to);
void stencil_free(struct stencil *s);

/* About how much memory one takes, before it is made [byte]. 0 for a box of
 * equal cells, in which nearly all hosts look alike. */
double stencil_bytes(const struct mesh *m, double b, enum stencil_to to);

/* How far every cell reaches from its centre [m], 3 a cell. */
double *stencil_extents(const struct mesh *m);

#endif
