/* mesh.h -- space as a list of faces.  Chapter 4.
 *
 * A face has an owner and, inside, a neighbour; its area vector S points from
 * the owner to the neighbour, or out of the domain. What leaves one cell
 * through a face enters the other, so a loop over faces conserves what it
 * moves. A periodic face is an ordinary face whose link vector d carries the
 * shift: only d, never the difference of two centres, says how far apart two
 * cells are.
 *
 * Faces 0 .. n_internal-1 have a neighbour; after them come the faces of each
 * patch. Vectors on cells and faces keep their components side by side: the
 * k-th component of cell c is at [3 * c + k].
 */
#ifndef MESH_H
#define MESH_H

/* A named stretch of boundary faces: first .. first + n - 1. */
struct patch {
    char name[32];
    int first, n;
};

/* What a box keeps of its regularity, to find cells and to write files. */
struct box {
    int n[3];        /* [-] cells per direction */
    int periodic[3]; /* [-] 1 where the two ends are one */
    double *edge[3]; /* [m] n + 1 cell edges per direction, ascending */
};

struct mesh {
    int n_cells, n_faces, n_internal;
    double *V;      /* [m^3] cell volume */
    double *centre; /* [m] cell centre, 3 a cell */
    int *owner;     /* [-] n_faces */
    int *neighbour; /* [-] n_internal */
    double *S;      /* [m^2] area vector, 3 a face */
    double *d;      /* [m] owner to neighbour centre (boundary: to the face
                       centre), 3 a face */
    double *w;      /* [-] share of the owner in a linear face value
                       (boundary: 0, the face has a value of its own) */
    int n_patches;
    struct patch *patches;
    int *cell_start; /* [-] n_cells + 1; faces of cell c are */
    int *cell_face;  /* [-] cell_face[cell_start[c]] ..., ascending */
    double *out;     /* [-] beside it: 1 if S points out of the cell, else -1 */
    struct box box;  /* of a box; else n is 0 */
    double *middle;  /* [m] of each face, 3; NULL for a box */
    int oblique;     /* 1: some link is not normal to its face */
};

/* A box of cells. grading is the ratio of the last to the first cell width, 1
 * for equal cells. Cells are numbered x fastest, then y, then z. Patches:
 * left right (x), bottom top (y), back front (z); none where periodic. */
struct box_spec {
    double size[3]; /* [m] */
    int cells[3];
    double grading[3];
    int periodic[3];
};

struct mesh *mesh_create_box(const struct box_spec *spec);
void mesh_free(struct mesh *m);

/* The one cell that owns the point, or -1 outside. A point on a face belongs
 * to the cell above it, on the upper end of the box to the last cell; in a
 * periodic direction the point is wrapped first. */
int mesh_cell_at(const struct mesh *m, double x, double y, double z);

/* The same on any mesh, by a walk from face to face that begins in a cell near
 * by: through the face that the point is farthest beyond, until it is beyond
 * none. A walk that leads nowhere, round a hole or out of a hollow, is followed
 * by a look at all cells. -1 outside. */
int mesh_cell_from(const struct mesh *m, int begin, double x, double y,
                   double z);

/* How good a mesh is. */
struct mesh_quality {
    double openness;        /* [-] mesh_openness */
    double non_orthogonal;  /* [deg] largest angle between S and d */
    double skewness;        /* [-] largest distance of a face's middle from
                               where its link crosses it, over the link */
    double V_least, V_most; /* [m^3] */
};
struct mesh_quality mesh_quality(const struct mesh *m);

/* The patch of that name, or NULL. */
const struct patch *mesh_patch(const struct mesh *m, const char *name);

/* For those who make meshes. Makes the arrays for the numbers of cells, faces
 * and patches that m has; and, when all faces are there, finds the faces of the
 * cells and whether a link is oblique. */
void mesh_allocate(struct mesh *m);
void mesh_collect_faces(struct mesh *m);

/* S - d S.S / S.d: the part of the area of inner face f that its link does not
 * stand for [m^2]. */
void mesh_oblique_part(const struct mesh *m, int f, double rest[3]);

/* The directions with more than one cell: 1, 2 or 3 (0 for a single cell). */
int mesh_dimensions(const struct mesh *m);

/* Largest |sum of S| over the faces of a cell, over its surface [-]: 0 for a
 * closed mesh up to rounding. */
double mesh_openness(const struct mesh *m);

#endif
