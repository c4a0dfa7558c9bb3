/* faces.h -- loops over the faces of a mesh, and over the faces of its cells.
 *
 * Chapter "Linear solvers".
 *
 * A loop is written once, as an inline function of one face: FOR_EACH_FACE
 * calls it for each inner face, face_loops_sum for each face of each cell. The
 * plain way follows the lists: owner[f] and neighbour[f] of face f, and
 * cell_face[a] of cell c for cell_start[c] <= a < cell_start[c + 1]. Where the
 * faces form contiguous pieces, in which face f + 1 joins the cells after those
 * that face f joins, the loops follow the pieces and need no lists (faces.c).
 * Both ways compute the same terms, and in each way the sum over the faces of a
 * cell has one order of its terms.
 *
 * The function must not read what is written for another face.
 */
#ifndef LINEAR_FACES_H
#define LINEAR_FACES_H

#include <stddef.h>

#include "base/parallel_ranges.h"

/* Faces face, face + 1, ... of the cells cell, cell + 1, ..., with the cells
 * other, other + 1, ... on their other sides. A face leaves its owner (out = 1)
 * and enters its neighbour (out = -1). */
struct face_piece {
    int face, cell, other, n;
    double out;
    const int *owner, *neighbour; /* [-] of a list of faces, in the place of
                                     cell and other; NULL */
    int axis;                     /* [-] of the area vectors, or 0 */
    int group, range;             /* where the next piece is searched */
};

/* The faces as contiguous pieces. Both functions iterate from a piece {0} over
 * faces of the cells first .. last - 1 and return 0 after the last piece:
 * faces_next_of_owners over those that the cells own, first the inner faces,
 * then those of the boundary; faces_next_of_cells over all. The order of the
 * faces of a cell does not depend on first and last. */
struct face_pieces;
int faces_next_of_owners(const struct face_pieces *r, int first, int last,
                         struct face_piece *p);
int faces_next_of_cells(const struct face_pieces *r, int first, int last,
                        struct face_piece *p);

/* Finds the pieces of the n_inner faces that have neighbours and of the
 * boundary faces after them; NULL if they are too short on average. */
struct face_pieces *faces_find_pieces(int n_inner, int n, const int *owner,
                                      const int *neighbour);

/* The faces of a mesh; all arrays are borrowed. */
struct faces {
    int n_inner, n; /* faces between two cells; with those of the boundary */
    int n_cells;
    const int *owner, *neighbour;      /* [-] n, n_inner */
    const int *cell_start, *cell_face; /* [-] the faces of each cell */
    const signed char *out;     /* [-] 1: cell_face[a] leaves the cell, or -1 */
    const double *S;            /* [m^2] area vectors, 3 each; or NULL */
    const int *S_at;            /* [-] n, which of them; NULL: each its own */
    struct face_pieces *pieces; /* NULL: loops follow the lists */
    double *area; /* [m^2] where each face is normal to an axis, that
                     component of S; else NULL */
};

/* 1 if a loop may read `area` in the place of S: a third of the bytes. */
static inline int faces_aligned(const struct faces *f)
{
    return f->pieces != NULL && f->area != NULL;
}

/* What a loop over the inner faces divides into ranges: cells, whose numbers
 * all their faces then read from the cache; without pieces the faces. */
static inline int faces_parts(const struct faces *f)
{
    return f->pieces != NULL ? f->n_cells : f->n_inner;
}

/* The next piece of the inner faces of the parts first .. last - 1: as
 * faces_next_of_owners, or all of these faces as one list. */
int faces_next(const struct faces *f, int first, int last,
               struct face_piece *p);

/* Finds the pieces of f; the areas belong to them. */
void faces_divide(struct faces *f);

/* sum[3 c + k] = the sum over the faces f < n of each cell first <= c < last:
 * a[f] S[3 f + k] if c is the owner, sign b[f] S[3 f + k] if the neighbour. */
void faces_sum_vectors(const struct faces *f, int first, int last, int n,
                       const double *a, double sign, const double *b,
                       double *sum);

/* --- face loops ----------------------------------------------------------- */

/* The loops.
 *
 * The function of one face, `each`, must be inlined into them: the compiler
 * forms one vectorised loop only then. It is declared with FACE_KERNEL or
 * FACE_SUM_KERNEL, and what it needs is handed on in `with`. */

#define FACE_KERNEL static inline __attribute__((always_inline)) void
#define FACE_SUM_KERNEL static inline __attribute__((always_inline)) double

/* Calls each(f, owner, neighbour, with) for all inner faces; m is how many
 * numbers the loop reads and writes for each face. */
#define FOR_EACH_FACE(of, m, each, with)                                       \
    PARALLEL_BLOCKS(faces_parts(of), m, face_loops_each, of, each, with)

/* The same for the parts first .. last - 1. */
FACE_KERNEL face_loops_each(int first, int last, const struct faces *of,
                            void (*each)(int f, int o, int n, const void *with),
                            const void *with)
{
    struct face_piece p = {0};

    while (faces_next(of, first, last, &p)) {
        const int f = p.face, o = p.cell, n = p.other, m = p.n;
        const int *const owner = p.owner, *const neighbour = p.neighbour;

        if (owner == NULL) {
#pragma omp simd
            for (int j = 0; j < m; j++)
                each(f + j, o + j, n + j, with);
        } else {
#pragma omp simd
            for (int j = 0; j < m; j++)
                each(f + j, owner[j], neighbour[j], with);
        }
    }
}

/* Adds each(f, out, with) of all faces f of cell c to sum[c], for the cells
 * first .. last - 1. */
FACE_KERNEL face_loops_sum(int first, int last, const struct faces *of,
                           double (*each)(int f, double out, const void *with),
                           const void *with, double *sum)
{
    struct face_piece p = {0};

    for (int c = first; of->pieces == NULL && c < last; c++)
        for (int a = of->cell_start[c]; a < of->cell_start[c + 1]; a++)
            sum[c] += each(of->cell_face[a], of->out[a], with);
    while (of->pieces != NULL &&
           faces_next_of_cells(of->pieces, first, last, &p)) {
        double *const s = sum + p.cell;
        const int f = p.face, m = p.n;
        const double out = p.out;

#pragma omp simd
        for (int j = 0; j < m; j++)
            s[j] += each(f + j, out, with);
    }
}

/* The flux out of a cell through a face, for face_loops_sum; unit of phi. */
FACE_SUM_KERNEL face_loops_outflow(int f, double out, const void *phi)
{
    return out * ((const double *)phi)[f];
}

#endif
