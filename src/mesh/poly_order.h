/* poly_order.h -- in which order a mesh from files is kept.
 *
 * Memory should come in the order in which it is used. So if the cells that
 * touch have numbers far apart, the cells are numbered anew; and if they are
 * few distances apart, as in blocks, the faces are sorted by distance, which
 * gives runs (linear/runs.h), else by owner.
 */
#ifndef POLY_ORDER_H
#define POLY_ORDER_H

#include "mesh/poly_raw.h"

/* Makes r->number: in waves from the first cell on, or the files' own numbers
 * if they keep cells that touch as close. */
void poly_number_cells(struct poly_raw *r);

/* The order of n inner faces, of which are known the lower cell and how far
 * apart the cells are numbered; to be freed. */
int *poly_face_order(int n, int n_cells, const int *least, const int *distance);

#endif
