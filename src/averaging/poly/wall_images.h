/* wall_images.h -- the images of cells behind the walls of any mesh.
 *
 * Chapter "Further averaging methods".
 *
 * A wall (any boundary face) acts as a mirror: the part of a particle's kernel
 * behind the wall is added to the cell that is mirrored there [EW18 21].
 * Instead of the image of each particle the images of each cell are stored,
 * because cells do not move; the distance is the same.
 *
 * Each point behind the walls is assigned to the nearest wall, and at an edge
 * to the plane that it is farthest beyond. It is the image of the point found
 * by reflection, if necessary repeated, until the result is in the mesh. The
 * images of all cells thus fill the space behind the walls once, in corners of
 * any angle and behind steps. Behind flat walls each image has the size of its
 * cell. Behind concave walls (a tube from inside) inner cells have several
 * images, because the space behind is wider; behind convex walls some cells
 * have none.
 */
#ifndef AVERAGING_POLY_WALL_IMAGES_H
#define AVERAGING_POLY_WALL_IMAGES_H

#include "averaging/poly/facets.h"

struct wall_image {
    double offset[3]; /* [m] from the centre of the cell to that of its image */
    double rotation[9]; /* [-] maps a vector of the cell to its image; row by
                           row */
    double weight;      /* [-] 1, or less on the bisector of two walls */
};

struct wall_images {
    int *start;                /* [-] n_cells + 1; the images of cell c are */
    struct wall_image *images; /* images[start[c]] ... */
};

/* All images of cells that are at most reach [m] behind a wall. */
struct wall_images *wall_images_create(const struct facets *f, double reach);
void wall_images_free(struct wall_images *m);

#endif
