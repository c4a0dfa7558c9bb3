/* poly_order.h -- in which order a mesh from files is kept.
 *
 * Memory should come in the order in which it is used. Cells that are in rows,
 * as in a block, stay as they are, and cells that could be are put in rows
 * (poly_rows.h); the faces are then sorted by how far apart their cells are
 * numbered, which gives runs (linear/runs.h). Of other cells those that touch
 * get numbers close to each other, and the faces go by owner.
 */
#ifndef POLY_ORDER_H
#define POLY_ORDER_H

#include "mesh/poly_raw.h"

/* Makes r->number: the files' own numbers or new ones, in rows if either are;
 * else in waves from the first cell on, or again the files' own; of two kinds
 * that with which cells that touch are closer. */
void poly_number_cells(struct poly_raw *r);

/* The order of n inner faces, of which are known the lower cell and how far
 * apart the cells are numbered; to be freed. */
int *poly_face_order(int n, int n_cells, const int *least, const int *distance);

/* Their boundary faces without the cyclic ones, patch after patch, in the order
 * of the cells; to be freed. */
int *poly_boundary_order(const struct poly_raw *r);

#endif
