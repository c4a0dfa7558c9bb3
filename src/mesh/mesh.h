/* mesh.h -- a mesh as a list of faces.
 * Chapter "The mesh".
 *
 * A face has an owner and, inside, a neighbour; its area vector S points from
 * the owner to the neighbour, or out of the domain. What leaves one cell
 * through a face enters the other, so a sum over faces is conservative. A
 * periodic face is an ordinary face whose link vector d includes the period:
 * only d, never the difference of two centres, gives the distance between two
 * cells.
 *
 * Faces 0 .. n_internal-1 have a neighbour; the faces of each patch follow. The
 * components of vectors on cells and faces are interleaved: the k-th component
 * of cell c is at [3 * c + k].
 */
#ifndef MESH_MESH_H
#define MESH_MESH_H

#include "base/key.h"

/* The largest number of faces: arrays of four numbers a face, or twelve a cell,
 * can then still be indexed by an int. */
enum { MESH_MOST_FACES = 536870911 };

/* A named range of boundary faces: first .. first + n - 1. */
struct patch {
    char name[64];
    int first, n;
    int is_symmetry; /* [-] 1: a symmetry plane by default */
};

/* The regular structure of a box, with which cells are located and files
 * written. */
struct box {
    int n[3];        /* [-] cells per direction */
    int periodic[3]; /* [-] 1 where the two ends are one */
    double *edge[3]; /* [m] n + 1 cell edges per direction, ascending */
};

/* The corners of a mesh that is not a box, needed to draw its cells and to
 * place walls on its faces. */
struct mesh_shape {
    int n_points, n_polygons;
    double *point;       /* [m] 3 a point */
    int *start, *corner; /* [-] n_polygons + 1; the points of each */
    int *cell_start;     /* [-] n_cells + 1; the polygons of each cell are */
    int *polygon;        /* [-] polygon[cell_start[c]] ... */
    int *turned;         /* [-] beside it: 1 if the normal by the order of its
                            corners points out of the cell, -1 if into it */
    int *boundary;       /* [-] the polygon of each boundary face */
};

struct mesh {
    int n_cells, n_faces, n_internal;
    double *V;      /* [m^3] cell volume */
    double *centre; /* [m] cell centre, 3 a cell */
    int *owner;     /* [-] n_faces */
    int *neighbour; /* [-] n_internal */
    /* Area vectors [m^2] and link vectors, from the owner to the neighbour
     * centre (boundary: to the face centre) [m], 3 each. Faces of a box share
     * them, except on the boundary; mesh_S and mesh_d have those of a face. */
    double *S, *d;
    int n_S, n_d;
    int *S_at, *d_at; /* [-] n_faces: which of them; NULL: each its own */
    double *w;        /* [-] weight of the owner in a linear face value
                         (boundary: 0, the face has a value of its own) */
    int n_patches;
    struct patch *patches;
    int *cell_start; /* [-] n_cells + 1; faces of cell c are */
    int *cell_face;  /* [-] cell_face[cell_start[c]] ..., ascending */
    signed char
        *out;       /* [-] beside it: 1 if S points out of the cell, else -1 */
    struct box box; /* of a box; else n is 0 */
    int oblique;    /* 1: some link vector d is not normal to its face */
    int skewed;     /* 1: some link misses the middle of its face; 2: and some
                       cell is a tetrahedron */
    double lo[3], hi[3]; /* [m] the smallest box around the mesh */
    int reference_count; /* [-] number of further owners, each of which calls
                            mesh_free */
    /* The following are set for polyhedral meshes only; else NULL and 0. */
    double *face_centre; /* [m] of each face, 3; on the owner's side */
    struct mesh_shape *shape;
    struct bins *bins; /* with which the cell of a point is found (locate.c) */
    int n_periods;
    double period[3][3]; /* [m] shifts that lead from one end to the other */
    int *periodic_index; /* [-] n_internal, NULL without periods: k + 1 if the
                            face is moved by period k for the neighbour, -(k +
                            1) if by minus it */
};

/* The area vector of a face [m^2], 3. */
static inline const double *mesh_S(const struct mesh *m, int f)
{
    return m->S + 3L * (m->S_at != NULL ? m->S_at[f] : f);
}

/* Its link vector, from the owner to the neighbour [m], 3. */
static inline const double *mesh_d(const struct mesh *m, int f)
{
    return m->d + 3L * (m->d_at != NULL ? m->d_at[f] : f);
}

/* The link vectors of the inner faces in their order [m], to be freed. */
double *mesh_links(const struct mesh *m);

/* A box of cells. grading is the ratio of the last to the first cell width, 1
 * for equal cells. Cells are numbered x fastest, then y, then z. Patches:
 * left right (x), bottom top (y), back front (z); none where periodic. */
struct box_spec {
    double size[3]; /* [m] */
    int cells[3];
    double grading[3];
    int periodic[3];
};

/* It must have no more than MESH_MOST_FACES faces. */
struct mesh *mesh_create_box(const struct box_spec *spec);

/* The outline of such a box without the arrays of cells and faces: their
 * numbers, the edges, the patches. It takes no time for any number of cells,
 * and is all that the checks before a run need. */
struct mesh *mesh_outline_box(const struct box_spec *spec);

void mesh_free(struct mesh *m);

/* Adds an owner, which must also call mesh_free, and returns the mesh. */
struct mesh *mesh_retain(struct mesh *m);

/* The cell that contains the point, or -1 outside. A point on a face belongs to
 * the cell on its upper side, a point on the upper end of the box to the last
 * cell; in a periodic direction the point is first moved into the box. */
int mesh_cell_at(const struct mesh *m, double x, double y, double z);

/* mesh_cell_at, and the vector from the centre of the cell to the point, across
 * a period if need be [m]; the vector is not set if the point is outside. */
int mesh_cell_and_offset(const struct mesh *m, const double x[3],
                         double offset[3]);

/* Names of the patches of a box: left right bottom top back front. */
extern const char *const mesh_sides[6];

/* The patch of that name, or NULL. */
const struct patch *mesh_patch(const struct mesh *m, const char *name);

/* The period in direction k, if there is one along that axis alone [m]; else
 * 0. */
double mesh_period(const struct mesh *m, int k);

/* For functions that create meshes. mesh_allocate creates the arrays for the
 * numbers of cells, faces and patches in m, and for its n_S and n_d vectors or,
 * where these are 0, for each face its own; when all faces are set,
 * mesh_collect_faces finds the faces of each cell and whether a link is
 * non-orthogonal, or misses the middle of its face. */
void mesh_allocate(struct mesh *m);
void mesh_collect_faces(struct mesh *m);

/* S - d S.S / S.d: the non-orthogonal part of the area vector of inner face f
 * [m^2]. */
void mesh_oblique_part(const struct mesh *m, int f, double oblique[3]);

/* off = the vector to the centre of inner face f from the point where the link
 * crosses it; of a boundary face, the part of its link that is parallel to it
 * [m]. */
void mesh_off_middle(const struct mesh *m, int f, double off[3]);

/* The same, and whether it is more than 1e-6 of the link [-]. */
int mesh_misses_middle(const struct mesh *m, int f, double off[3]);

/* The mesh that a case asks for: a box and its cells, a
 * sheared box, or a mesh from files. */

struct mesh_options {
    struct box_spec box; /* its size and cells are 0 where they are left out */
    double shear[3];     /* [-] of the box along x over y, x over z, y over z */
    const char *polymesh; /* the folder of a mesh from files; NULL: a box */
    int has_grading, has_periodic, has_shear; /* [-] 1: the case has the key */
};

extern const struct key mesh_keys[];

#endif
