/* runs.h -- links in a row between cells in a row.  Chapter 7.
 *
 * Between a row of cells and the next row of a box, link l + 1 joins the cells
 * after those that link l joins. Over such a run a loop needs no list of
 * owners and neighbours: it reads and writes memory as it lies, eight numbers
 * at a time (measured: three to five times faster). Where most links stand
 * alone, as in a mesh that was shuffled, loops go by the lists.
 *
 * A loop is written once, as an inline function of one link, and LINKS_RUN or
 * CELLS_SUM calls it for all, by runs or by lists. It must not read what is
 * written for another link; links of a run share no owner and no neighbour.
 */
#ifndef RUNS_H
#define RUNS_H

#include <stddef.h>

enum {
    RUNS_GROUPS = 16, /* at most */
    RUNS_WORTH_IT = 8 /* links in a run, on average */
};

struct run {
    int link, owner, n; /* the first link, its owner, how many */
};

struct runs {
    int n_groups;
    struct {
        int first, end; /* its runs, with ascending links and owners */
        int distance;   /* from owner to neighbour */
        int boundary;   /* 1: no neighbours */
    } group[RUNS_GROUPS];
    struct run *run;
};

/* The runs of n_inner links with neighbours and the others, up to n_links,
 * without; or NULL if there are too few links in a run. */
struct runs *runs_create(int n_inner, int n_links, const int *owner,
                         const int *neighbour);
void runs_free(struct runs *r);

/* A part of a run: links link, link + 1, ... of the cells cell, cell + 1, ...,
 * and of the others. A link leaves its owner (out = 1) and enters its neighbour
 * (out = -1). */
struct piece {
    int link, cell, other, n;
    double out;
    int group, run; /* where the next one is looked for */
};

/* All pieces for the cells first .. last - 1, each with all its links: begin
 * with {0}; 0 when there are no more. A cell meets its links in the same order
 * whatever first and last are. */
int runs_next_of_cells(const struct runs *r, int first, int last,
                       struct piece *p);

/* All pieces for the links first .. last - 1, seen from the owner. */
int runs_next_of_links(const struct runs *r, int first, int last,
                       struct piece *p);

/* What such a function begins with: only inlined it becomes one loop. */
#define FACE_LOOP static inline __attribute__((always_inline)) void
#define FACE_SUM static inline __attribute__((always_inline)) double

/* clang-format off: it would break the pragmas apart. */

/* each(l, owner, neighbour, ...) for the inner links first .. last - 1. */
#define LINKS_RUN(r, first, last, owner_, neighbour_, each, ...)               \
    do {                                                                       \
        struct piece p_ = {0};                                                 \
        if ((r) == NULL) {                                                     \
            _Pragma("omp simd") for (int l_ = (first); l_ < (last); l_++)      \
                each(l_, (owner_)[l_], (neighbour_)[l_], __VA_ARGS__);         \
            break;                                                             \
        }                                                                      \
        while (runs_next_of_links(r, first, last, &p_)) {                      \
            const int at_ = p_.link, o_ = p_.cell, n_ = p_.other;              \
            _Pragma("omp simd") for (int j_ = 0; j_ < p_.n; j_++)              \
                each(at_ + j_, o_ + j_, n_ + j_, __VA_ARGS__);                 \
        }                                                                      \
    } while (0)

/* sum[c] += each(l, out, ...) of all links l of the cells first .. last - 1; by
 * lists they are list[start[c]] ..., with out beside them. */
#define CELLS_SUM(r, first, last, start, list, out_, sum, each, ...)           \
    do {                                                                       \
        struct piece p_ = {0};                                                 \
        for (int c_ = (first); (r) == NULL && c_ < (last); c_++) {             \
            double s_ = (sum)[c_];                                             \
            for (int a_ = (start)[c_]; a_ < (start)[c_ + 1]; a_++)             \
                s_ += each((list)[a_], (out_)[a_], __VA_ARGS__);               \
            (sum)[c_] = s_;                                                    \
        }                                                                      \
        while ((r) != NULL && runs_next_of_cells(r, first, last, &p_)) {       \
            double *const s_ = (sum) + p_.cell;                                \
            const int at_ = p_.link;                                           \
            const double o_ = p_.out;                                          \
            _Pragma("omp simd") for (int j_ = 0; j_ < p_.n; j_++) s_[j_] +=    \
                each(at_ + j_, o_, __VA_ARGS__);                               \
        }                                                                      \
    } while (0)
/* clang-format on */

#endif
