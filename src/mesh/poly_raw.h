/* poly_raw.h -- a mesh as OpenFOAM's five files have it, and its measures. */
#ifndef POLY_RAW_H
#define POLY_RAW_H

enum { POLY_RAW_PATCHES = 64 };

/* A patch as the file has it. */
struct poly_part {
    char name[32], type[32], other[32];
    int first, n;
};

/* The files, and what is made of them on the way. */
struct poly_raw {
    int n_points, n_faces, n_inner, n_cells, n_parts;
    double *point;          /* [m] 3 each */
    int *start, *corner;    /* [-] the points of face f */
    int *owner, *neighbour; /* [-] as in the files */
    double *middle, *area;  /* [m], [m^2] of each face, 3 each */
    double *V, *centre;     /* [m^3], [m] of each cell */
    int *number;            /* [-] the new number of a cell */
    struct poly_part part[POLY_RAW_PATCHES];
};

/* Reads the files in dir; non-zero after one message. */
int poly_raw_read(struct poly_raw *r, const char *dir);

/* Middles and areas of the faces, volumes and centres of the cells; non-zero
 * after one message if a volume is not positive. */
int poly_raw_measure(struct poly_raw *r, const char *dir);

void poly_raw_release(struct poly_raw *r);

#endif
