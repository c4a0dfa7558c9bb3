/* poly_raw.h -- a mesh as stored in OpenFOAM's five files, and its geometry. */
#ifndef MESH_POLY_POLY_RAW_H
#define MESH_POLY_POLY_RAW_H

#include "mesh/mesh.h"

enum { POLY_RAW_PATCHES = 10000 };

/* A patch of the file. */
struct poly_part {
    char name[64], type[64], other[64];
    int first, n;
    int line;           /* [-] of the file */
    int periodic_index; /* [-] of a cyclic patch: its period as in mesh.h, else
                           0 */
};

/* The contents of the files, and the quantities derived from them. */
struct poly_raw {
    struct inputs **files; /* borrowed; NULL: nothing is kept */
    int n_points, n_faces, n_inner, n_cells, n_parts;
    double *point;          /* [m] 3 each */
    int *start, *corner;    /* [-] the points of face f */
    int *owner, *neighbour; /* [-] as in the files */
    double *middle, *area;  /* [m], [m^2] of each face, 3 each */
    double *V, *centre;     /* [m^3], [m] of each cell */
    int *number;            /* [-] the new number of a cell */
    struct poly_part *part; /* n_parts of them */
};

/* Reads the files in dir; non-zero after one message. */
int poly_raw_read(struct poly_raw *r, const char *dir);

/* Only the patches. */
int poly_raw_read_parts(struct poly_raw *r, const char *dir);

/* Computes the middles and areas of the faces, and the volumes and centres of
 * the cells; non-zero after one message if a face has no area, or a cell is not
 * closed or has no positive volume. */
int poly_raw_measure(struct poly_raw *r, const char *dir);
double poly_raw_warp(const struct poly_raw *r);

void poly_raw_release(struct poly_raw *r);

/* Creates the mesh; NULL after one message. The points and corners of the raw
 * mesh move to the new one; the raw mesh must still be released. */
struct mesh *poly_build(struct poly_raw *r, const char *dir);
struct mesh_shape *poly_shape_create(struct poly_raw *r);

/* The numbering of a mesh from files.
 *
 * Data should lie in memory in the order in which loops use them. Cells that
 * are numbered in rows, as in a block, keep their numbers, and cells that can
 * be numbered in rows are (poly_order.c); the faces are then sorted by the
 * difference of the numbers of their cells, which gives contiguous ranges
 * (linear/faces.h). Otherwise neighbouring cells receive close
 * numbers, and the faces are sorted by owner.
 */

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
