/* contiguous_faces.h -- contiguous ranges of links between contiguous ranges of
 * cells. Chapter 7.
 *
 * Between a row of cells and the next row of a box, link l + 1 joins the cells
 * after those that link l joins. A loop over such a range needs no list of
 * owners and neighbours: it reads and writes contiguous memory, eight numbers
 * at a time (measured: three to five times faster). Where most ranges have one
 * link, as in a mesh with shuffled numbers, loops use the lists.
 *
 * A loop is written once, as an inline function of one link; FOR_EACH_FACE or
 * SUM_OVER_FACES calls this function for all links, by contiguous ranges or by
 * lists. The function must not read what is written for another link; the links
 * of a range have different owners and different neighbours.
 */
#ifndef LINEAR_FAST_CONTIGUOUS_FACES_H
#define LINEAR_FAST_CONTIGUOUS_FACES_H

#include <stddef.h>

enum {
    CONTIGUOUS_FACES_GROUPS = 16,   /* at most */
    CONTIGUOUS_FACES_MIN_LENGTH = 8 /* links in a run, on average */
};

struct contiguous_range {
    int link, owner, n; /* the first link, its owner, how many */
};

struct contiguous_faces {
    int n_groups;
    struct {
        int first,
            end; /* its contiguous ranges, with ascending links and owners */
        int distance; /* from owner to neighbour */
        int boundary; /* 1: no neighbours */
    } group[CONTIGUOUS_FACES_GROUPS];
    struct contiguous_range *range;
};

/* Finds the ranges of the first n_inner links, which have neighbours, and of
 * the others, up to n_links, which have none. Returns NULL if the ranges are
 * too short on average. */
struct contiguous_faces *contiguous_faces_create(int n_inner, int n_links,
                                                 const int *owner,
                                                 const int *neighbour);
void contiguous_faces_free(struct contiguous_faces *r);

/* A part of a range: links link, link + 1, ... of the cells cell, cell + 1,
 * ..., and of the cells other, other + 1, ... on their other sides. A link
 * leaves its owner (out = 1) and enters its neighbour (out = -1). */
struct contiguous_piece {
    int link, cell, other, n;
    double out;
    int group, range; /* where the next one is looked for */
};

/* Iterates over all pieces for the cells first .. last - 1, each with all its
 * links. The caller begins with {0}; the function returns 0 after the last
 * piece. The order of the links of a cell does not depend on first and last. */
int contiguous_faces_next_of_cells(const struct contiguous_faces *r, int first,
                                   int last, struct contiguous_piece *p);

/* Iterates over all pieces of the links first .. last - 1, from their owners.
 */
int contiguous_faces_next_of_faces(const struct contiguous_faces *r, int first,
                                   int last, struct contiguous_piece *p);

/* The function of one link is declared with one of these prefixes, because the
 * compiler forms one loop only if it is inlined. */
#define FACE_KERNEL static inline __attribute__((always_inline)) void
#define FACE_SUM_KERNEL static inline __attribute__((always_inline)) double

/* clang-format off: it would break the pragmas apart. */

/* each(l, owner, neighbour, ...) for the inner links first .. last - 1. */
#define FOR_EACH_FACE(r, first, last, owner_, neighbour_, each, ...)           \
    do {                                                                       \
        struct contiguous_piece p_ = {0};                                      \
        if ((r) == NULL) {                                                     \
            _Pragma("omp simd") for (int l_ = (first); l_ < (last); l_++)      \
                each(l_, (owner_)[l_], (neighbour_)[l_], __VA_ARGS__);         \
            break;                                                             \
        }                                                                      \
        while (contiguous_faces_next_of_faces(r, first, last, &p_)) {          \
            const int at_ = p_.link, o_ = p_.cell, n_ = p_.other;              \
            _Pragma("omp simd") for (int j_ = 0; j_ < p_.n; j_++)              \
                each(at_ + j_, o_ + j_, n_ + j_, __VA_ARGS__);                 \
        }                                                                      \
    } while (0)

/* sum[c] += each(l, out, ...) of all links l of the cells first .. last - 1; by
 * lists they are list[start[c]] ..., with out beside them. */
#define SUM_OVER_FACES(r, first, last, start, list, out_, sum, each, ...)      \
    do {                                                                       \
        struct contiguous_piece p_ = {0};                                      \
        for (int c_ = (first); (r) == NULL && c_ < (last); c_++) {             \
            double s_ = (sum)[c_];                                             \
            for (int a_ = (start)[c_]; a_ < (start)[c_ + 1]; a_++)             \
                s_ += each((list)[a_], (out_)[a_], __VA_ARGS__);               \
            (sum)[c_] = s_;                                                    \
        }                                                                      \
        while ((r) != NULL &&                                                  \
               contiguous_faces_next_of_cells(r, first, last, &p_)) {          \
            double *const s_ = (sum) + p_.cell;                                \
            const int at_ = p_.link;                                           \
            const double o_ = p_.out;                                          \
            _Pragma("omp simd") for (int j_ = 0; j_ < p_.n; j_++) s_[j_] +=    \
                each(at_ + j_, o_, __VA_ARGS__);                               \
        }                                                                      \
    } while (0)
/* clang-format on */

#endif
