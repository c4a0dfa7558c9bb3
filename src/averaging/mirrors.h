/* mirrors.h -- the images of cells behind the walls of any mesh.  Chapter 21.
 *
 * A wall, any boundary face, is a mirror: what a particle would give to the
 * room behind it comes back to the cell that is seen there [EW18 21]. Instead
 * of the image of each particle we keep those of each cell, for they do not
 * move: the distance is the same.
 *
 * Each point behind the walls belongs to the wall that is nearest to it, and
 * at an edge to the plane that it is farthest beyond. It shows the point that
 * is mirrored there, if need be several times, until it is in the mesh. So the
 * images of all cells fill the room behind the walls once, in corners of any
 * angle and behind steps. Behind flat walls they do so as equals of the cells.
 * Behind hollow ones (a tube from inside) inner cells are seen several times,
 * for the room behind is wider; behind bulging ones some are not seen.
 */
#ifndef MIRRORS_H
#define MIRRORS_H

#include "averaging/facets.h"

struct image {
    double at[3];   /* [m] from the centre of the cell to that of its image */
    double turn[9]; /* [-] what is r in the cell is turn r here; row by row */
    double part;    /* [-] 1, or less on the bisector of two walls */
};

struct mirrors {
    int *start;          /* [-] n_cells + 1; the images of cell c are */
    struct image *image; /* image[start[c]] ... */
};

/* All images of cells that are at most reach [m] behind a wall. */
struct mirrors *mirrors_create(const struct facets *f, double reach);
void mirrors_free(struct mirrors *m);

#endif
