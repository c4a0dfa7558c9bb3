/* face_loops.h -- the loops of faces.h. Chapter "Linear solvers".
 *
 * The function of one face, `each`, must be inlined into them: the compiler
 * forms one vectorised loop only then. It is declared with FACE_KERNEL or
 * FACE_SUM_KERNEL, and what it needs is handed on in `with`.
 */
#ifndef LINEAR_FACE_LOOPS_H
#define LINEAR_FACE_LOOPS_H

#include <stddef.h>

#include "base/parallel_ranges.h"
#include "linear/faces.h"

#define FACE_KERNEL static inline __attribute__((always_inline)) void
#define FACE_SUM_KERNEL static inline __attribute__((always_inline)) double

/* Calls each(f, owner, neighbour, with) for all inner faces; m is how many
 * numbers the loop reads and writes for each face. */
#define FOR_EACH_FACE(of, m, each, with)                                       \
    PARALLEL_RANGES((of)->n_inner, m, face_loops_each, of, each, with)

/* The same for the inner faces first .. last - 1. */
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
