/* poly.h -- meshes of OpenFOAM: points, faces, owner, neighbour, boundary.
 *
 * Chapter "The mesh".
 */
#ifndef MESH_POLY_POLY_H
#define MESH_POLY_POLY_H

#include "base/file.h"
#include "mesh/mesh.h"

/* The mesh of the five files in dir, or in dir/polyMesh or
 * dir/constant/polyMesh, ascii or binary, packed by gzip or not; NULL after
 * one message on stderr. What was read stays in `files`, if that is not NULL.
 * Cells and faces are renumbered (poly_order.c);
 * boundary faces stay in their patch. */
struct mesh *poly_read(const char *dir, struct inputs **files);

enum { POLY_FOLDER = 960 };
/* Finds the folder of the five files; 0 and dir itself if there is none. */
int poly_folder(const char *dir, char folder[POLY_FOLDER]);
/* 1 if such a folder exists; it is looked for where POLY_LOOKED_FOR says. */
#define POLY_LOOKED_FOR                                                        \
    "no file boundary in it, in polyMesh or in constant/polyMesh"
int poly_is(const char *dir);

struct mesh_patch_name {
    char name[64];
};

/* Reads only the names of the patches that are not cyclic. Returns their number
 * and a list that the caller frees; -1 after one message. */
int poly_patches(const char *dir, struct inputs **files,
                 struct mesh_patch_name **list);

/* The box of the specification, sheared: x grows by shear[0] y + shear[1] z, y
 * by shear[2] z. NULL after a message if its cells are too distorted. */
struct mesh *mesh_create_sheared(const struct box_spec *spec,
                                 const double shear[3]);

/* The search for the cell of a point in a polyhedral mesh. */

/* Creates m->bins; everything else of the mesh must be set. No corner is
 * farther from the plane of its face than slack [m]. */
void locate_create(struct mesh *m, double slack);

/* As mesh_cell_and_offset. */
int locate_cell(const struct mesh *m, const double x[3], double offset[3]);

/* The cell that contains x [m], or -1 outside, by a walk from cell to cell that
 * begins in the cell `begin`: each step crosses the face that the point is
 * farthest beyond, until the point is beyond none. If the walk fails (around a
 * hole, or out of a concave region), or begin is -1, all cells of the point's
 * bin are tested. offset [m] becomes the vector from the centre of the cell to
 * the point; it is not set outside. */
int locate_from(const struct mesh *m, int begin, const double x[3],
                double offset[3]);

/* --- poly file ------------------------------------------------------------ */

/* The words and numbers of one file of an OpenFOAM mesh.
 *
 * A file is a header in braces and a list, N ( ... ), between comments. Each
 * function reads the next item. The first error is reported on stderr with
 * file and line; then `failed` is set and every further item reads as 0. */

enum { POLY_WORD = 128 };

struct poly_file {
    char path[1024];
    const char *text; /* all of the file, borrowed from those that were read */
    struct inputs *own; /* where it is, if it is not kept */
    char *unpacked;     /* or made of it; NULL: it is not packed */
    long size;          /* [byte] */
    long at;            /* [-] the next character */
    int line;           /* [-] counted from 1 */
    int failed;
    int is_binary;     /* [-] 1: lists of numbers are bytes in brackets */
    int is_compact;    /* [-] 1: faces are where each begins, and all corners */
    int label, scalar; /* [byte] of a whole number and of a real one there */
    int in_bytes;      /* [-] 1: within such a list */
    long same; /* [-] where the number of a list of equal ones is, N{0}; or 0 */
};

/* Reads the file dir/name, or dir/name.gz, and its header. */
void poly_file_open(struct poly_file *p, struct inputs **files, const char *dir,
                    const char *name);
void poly_file_close(struct poly_file *p);

/* The next word, which ends before a blank or a sign; each of the signs ( ) { }
 * ; is a word of its own, and a text in quotes is one. */
void poly_file_word(struct poly_file *p, char word[POLY_WORD]);
void poly_file_expect(struct poly_file *p, const char *word);
int poly_file_int(struct poly_file *p);
/* The brackets around the n numbers of a list, which are words or bytes, or of
 * whole numbers one in braces for all. */
void poly_file_begin(struct poly_file *p, int n);
void poly_file_end(struct poly_file *p, int n);
/* The number of entries of a list: no more than the file can contain with
 * `least` characters or more each, and such that four times it is an int. With
 * 0 the caller limits it, as N{0} has one number for all entries. */
int poly_file_count(struct poly_file *p, int least);
double poly_file_real(struct poly_file *p);

/* Reports an error at the present line and sets `failed`. */
void poly_file_wrong(struct poly_file *p, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* --- poly raw ------------------------------------------------------------- */

/* A mesh as stored in OpenFOAM's five files, and its geometry. */

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
struct mesh_shape *poly_shape_create(struct mesh *m, struct poly_raw *r);

/* The numbering of a mesh from files.
 *
 * Data should lie in memory in the order in which loops use them. Cells that
 * are numbered in rows, as in a block, keep their numbers, and cells that can
 * be numbered in rows are (poly_order.c); the faces are then sorted by the
 * difference of the numbers of their cells, which gives contiguous ranges
 * (linear/faces.h). Otherwise neighbouring cells receive close
 * numbers, and the faces are sorted by owner. */

/* Sets r->number. If the cells can be numbered in rows, these numbers are used;
 * otherwise either the files' own numbers or a breadth-first numbering from the
 * first cell, whichever gives neighbouring cells closer numbers. */
void poly_number_cells(struct poly_raw *r);

/* The order of n inner faces between the cells a and b, by the difference of
 * both numbers, or by the lower one where in_rows becomes 0; the caller frees
 * it. */
int *poly_face_order(int n, int n_cells, const int *a, const int *b,
                     int *in_rows);

/* The boundary faces without the cyclic ones, patch after patch, in the order
 * of the cells; the caller frees the list. */
int *poly_boundary_order(const struct poly_raw *r);

#endif
