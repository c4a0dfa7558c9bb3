/* poly_rows.h -- the rows of a mesh of hexahedra.
 *
 * A row goes on from a cell through a face and the face opposite to it. So from
 * one cell on all others get three integers, as the cells of a box have,
 * however they are numbered and however the block is bent.
 */
#ifndef POLY_ROWS_H
#define POLY_ROWS_H

#include "mesh/poly_raw.h"

/* Three integers a cell, 3 * n_cells of them from 0 on, and how many there are
 * in each direction; to be freed. NULL if a cell is no hexahedron, or not all
 * are reached. */
int *poly_rows_find(const struct poly_raw *r, int extent[3]);

#endif
