/* poly_order.h -- the numbering of a mesh from files.
 *
 * Data should lie in memory in the order in which loops use them. Cells that
 * are numbered in rows, as in a block, keep their numbers, and cells that can
 * be numbered in rows are (poly_rows.h); the faces are then sorted by the
 * difference of the numbers of their cells, which gives contiguous ranges
 * (linear/fast/contiguous_faces.h). Otherwise neighbouring cells receive close
 * numbers, and the faces are sorted by owner.
 */
#ifndef MESH_POLY_POLY_ORDER_H
#define MESH_POLY_POLY_ORDER_H

#include "mesh/poly/poly_raw.h"

/* Sets r->number. If the cells can be numbered in rows, these numbers are used;
 * otherwise either the files' own numbers or a breadth-first numbering from the
 * first cell, whichever gives neighbouring cells closer numbers. */
void poly_number_cells(struct poly_raw *r);

/* The order of n inner faces, from the lower number of their cells and the
 * difference of both; the caller frees it. */
int *poly_face_order(int n, int n_cells, const int *least, const int *distance);

/* The boundary faces without the cyclic ones, patch after patch, in the order
 * of the cells; the caller frees the list. */
int *poly_boundary_order(const struct poly_raw *r);

#endif
