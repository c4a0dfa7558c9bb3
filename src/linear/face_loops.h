/* face_loops.h -- the loops of faces.h, as macros. Chapter "Linear solvers".
 *
 * The function of one face is declared with FACE_KERNEL or FACE_SUM_KERNEL: the
 * compiler forms one vectorised loop only if the function is inlined.
 */
#ifndef LINEAR_FACE_LOOPS_H
#define LINEAR_FACE_LOOPS_H

#include "base/parallel_ranges.h"
#include "linear/faces.h"

#define FACE_KERNEL static inline __attribute__((always_inline)) void
#define FACE_SUM_KERNEL static inline __attribute__((always_inline)) double

/* clang-format off: it would break the pragmas apart. */

/* Calls each(f, owner, neighbour, ...) for all inner faces; m is how many
 * numbers the loop reads and writes for each face. */
#define FOR_EACH_FACE(of, m, each, ...)                                        \
    PARALLEL_RANGES((of)->n_inner, m, FACES_OF_RANGE, of, each, __VA_ARGS__)

/* The same for the inner faces first .. last - 1. */
#define FACES_OF_RANGE(first, last, of, each, ...)                             \
    do {                                                                       \
        const struct faces *const fs_ = (of);                                  \
        if (fs_->pieces)                                                       \
            FACES_BY_PIECES(fs_, first, last, each, __VA_ARGS__);              \
        else                                                                   \
            FACES_BY_LISTS(fs_, first, last, each, __VA_ARGS__);               \
    } while (0)

#define FACES_BY_LISTS(fs, first, last, each, ...)                             \
    do {                                                                       \
        const int *const o_ = (fs)->owner, *const n_ = (fs)->neighbour;        \
        const int end_ = (last);                                               \
        _Pragma("omp simd") for (int f_ = (first); f_ < end_; f_++)            \
            each(f_, o_[f_], n_[f_], __VA_ARGS__);                             \
    } while (0)

#define FACES_BY_PIECES(fs, first, last, each, ...)                            \
    do {                                                                       \
        const struct face_pieces *const r_ = (fs)->pieces;                     \
        const int begin_ = (first), end_ = (last);                             \
        struct face_piece p_ = {0};                                            \
        while (r_->next_of_faces(r_, begin_, end_, &p_)) {                     \
            const int f_ = p_.face, o_ = p_.cell, n_ = p_.other, m_ = p_.n;    \
            _Pragma("omp simd") for (int j_ = 0; j_ < m_; j_++)                \
                each(f_ + j_, o_ + j_, n_ + j_, __VA_ARGS__);                  \
        }                                                                      \
    } while (0)

/* Adds each(f, out, ...) of all faces f of cell c to sum[c], for the cells
 * first
 * .. last - 1. */
#define SUM_OVER_FACES(of, first, last, sum, each, ...)                        \
    do {                                                                       \
        const struct faces *const fs_ = (of);                                  \
        if (fs_->pieces)                                                       \
            SUM_BY_PIECES(fs_->pieces, first, last, sum, each, __VA_ARGS__);   \
        for (int c_ = (first); !fs_->pieces && c_ < (last); c_++) {            \
            const int *const start_ = &fs_->cell_start[c_];                    \
            for (int a_ = start_[0]; a_ < start_[1]; a_++)                     \
                (sum)[c_] +=                                                   \
                    each(fs_->cell_face[a_], fs_->out[a_], __VA_ARGS__);       \
        }                                                                      \
    } while (0)

#define SUM_BY_PIECES(r, first, last, sum, each, ...)                          \
    do {                                                                       \
        struct face_piece p_ = {0};                                            \
        while ((r)->next_of_cells(r, first, last, &p_)) {                      \
            double *const s_ = (sum) + p_.cell;                                \
            const int f_ = p_.face, m_ = p_.n;                                 \
            const double out_ = p_.out;                                        \
            _Pragma("omp simd") for (int j_ = 0; j_ < m_; j_++) s_[j_] +=      \
                each(f_ + j_, out_, __VA_ARGS__);                              \
        }                                                                      \
    } while (0)
/* clang-format on */

/* The flux out of a cell through a face, for SUM_OVER_FACES; unit of phi. */
FACE_SUM_KERNEL face_loops_outflow(int f, double out, const double *phi)
{
    return out * phi[f];
}

#endif
