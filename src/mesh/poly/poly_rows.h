/* poly_rows.h -- the rows of a mesh of hexahedra.
 *
 * A row leads from a cell through a face and then through the face opposite to
 * it. Starting from one cell, every other cell is thus assigned three integers,
 * like the cells of a box, whatever the numbering and the shape of the block.
 */
#ifndef MESH_POLY_POLY_ROWS_H
#define MESH_POLY_POLY_ROWS_H

#include "mesh/poly/poly_raw.h"

/* The three integers of each cell, which begin at 0, and how many values they
 * have in each direction; the caller frees the list. NULL if a cell is no
 * hexahedron, or not all are reached. */
int *poly_rows_find(const struct poly_raw *r, int extent[3]);

#endif
