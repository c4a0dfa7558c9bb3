/* faces.h -- loops over the faces of a mesh, and over the faces of its cells.
 *
 * Chapter "Linear solvers".
 *
 * A loop is written once, as an inline function of one face: FOR_EACH_FACE of
 * face_loops.h calls it for each inner face, face_loops_sum for each face of
 * each cell. The plain way follows the lists: owner[f] and neighbour[f] of face
 * f, and cell_face[a] of cell c for cell_start[c] <= a < cell_start[c + 1].
 * Where the faces form contiguous pieces, in which face f + 1 joins the cells
 * after those that face f joins, the loops follow the pieces and need no lists
 * (faces.c). Both ways compute the same terms, and in each way
 * the sum over the faces of a cell has one order of its terms.
 *
 * The function must not read what is written for another face.
 */
#ifndef LINEAR_FACES_H
#define LINEAR_FACES_H

/* Faces face, face + 1, ... of the cells cell, cell + 1, ..., with the cells
 * other, other + 1, ... on their other sides. A face leaves its owner (out = 1)
 * and enters its neighbour (out = -1). */
struct face_piece {
    int face, cell, other, n;
    double out;
    const int *owner, *neighbour; /* [-] of a list of faces, in the place of
                                     cell and other; NULL */
    int group, range;             /* where the next piece is searched */
};

/* The faces as contiguous pieces. Both functions iterate from a piece {0} and
 * return 0 after the last piece: faces_next_of_faces over the inner and
 * boundary faces first .. last - 1 from their owners, faces_next_of_cells over
 * all faces of the cells first .. last - 1. The order of the faces of a cell
 * does not depend on first and last. */
struct face_pieces;
int faces_next_of_faces(const struct face_pieces *r, int first, int last,
                        struct face_piece *p);
int faces_next_of_cells(const struct face_pieces *r, int first, int last,
                        struct face_piece *p);

/* Finds the pieces of the n_inner faces that have neighbours and of the
 * boundary faces after them; NULL if they are too short on average. */
struct face_pieces *faces_find_pieces(int n_inner, int n, const int *owner,
                                      const int *neighbour);
void faces_free_pieces(struct face_pieces *r);

/* The faces of a mesh; all arrays are borrowed. */
struct faces {
    int n_inner, n; /* faces between two cells; with those of the boundary */
    const int *owner, *neighbour;      /* [-] n, n_inner */
    const int *cell_start, *cell_face; /* [-] the faces of each cell */
    const double *out;          /* [-] 1: cell_face[a] leaves the cell, or -1 */
    struct face_pieces *pieces; /* NULL: loops follow the lists */
};

/* The next piece of the inner faces first .. last - 1, as next_of_faces:
 * without pieces all of them are one, a list. */
int faces_next(const struct faces *f, int first, int last,
               struct face_piece *p);

/* Finds the pieces of f; faces_release frees them. */
void faces_divide(struct faces *f);
void faces_release(struct faces *f);

/* sum[3 c + k] = the sum over the faces f < n of each cell first <= c < last:
 * a[f] S[3 f + k] if c is the owner, sign b[f] S[3 f + k] if the neighbour. */
void faces_sum_vectors(const struct faces *f, int first, int last, int n,
                       const double *a, double sign, const double *b,
                       const double *S, double *sum);

#endif
