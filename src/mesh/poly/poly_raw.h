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

#endif
