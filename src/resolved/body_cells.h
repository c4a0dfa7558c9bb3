/* body_cells.h -- the cells in and around a body.
 * Chapter "Resolving the grains".
 *
 * The mesh is a box of equal cells. In a periodic direction the indices go on
 * beyond its ends.
 */
#ifndef RESOLVED_BODY_CELLS_H
#define RESOLVED_BODY_CELLS_H

#include "mesh/mesh.h"
#include "resolved/solid_bodies.h"

/* The cells of a box around a point. */
struct cell_window {
    int first[3], last[3]; /* [-] of each direction */
};

/* Walks over the indices at[3] of its cells, along x fastest. */
#define CELL_WINDOW_EACH(at, w)                                                \
    for (at[2] = (w).first[2]; at[2] <= (w).last[2]; at[2]++)                  \
        for (at[1] = (w).first[1]; at[1] <= (w).last[1]; at[1]++)              \
            for (at[0] = (w).first[0]; at[0] <= (w).last[0]; at[0]++)

/* The cells with a part within `extent` [m] of x [m], and one more layer. A
 * cell beside both ends of an extent that nearly meets itself across the period
 * is there twice; where the extent is a period long or longer, each is once. */
struct cell_window cell_window_around(const struct mesh *m, const double x[3],
                                      const double extent[3]);

/* The cell at these indices, and how far its centre is from x [m]. */
int cell_window_cell(const struct mesh *m, const int at[3], const double x[3],
                     double r[3]);

/* 1 if the box goes on beyond cell c on this side: 2 k the lower, 2 k + 1 the
 * upper one of direction k. */
static inline int box_goes_on(const struct box *b, int c, int side)
{
    const int k = side / 2, n = b->n[k];
    const int at = (k > 0 ? c / (k > 1 ? b->n[0] * b->n[1] : b->n[0]) : c) % n;

    if (b->periodic[k]) return n > 1;
    return side % 2 ? at < n - 1 : at > 0;
}

/* 1 if cell c touches no end of the box, so that the six beside it are c +- 1,
 * c +- a row, c +- a layer. */
static inline int box_is_amid(const struct box *b, int c)
{
    const int x = c % b->n[0], rows = c / b->n[0];
    const int y = rows % b->n[1], z = rows / b->n[1];

    return x > 0 && x < b->n[0] - 1 && y > 0 && y < b->n[1] - 1 && z > 0 &&
           z < b->n[2] - 1;
}

/* 1 if one of the six cells beside cell c, which is amid others, has a mark
 * that is neither 0 nor the same. */
static inline int box_meets_other(const struct box *b, const int *mark, int c)
{
    const int row = b->n[0], layer = row * b->n[1];
    const int beside[] = {c - layer, c - row, c - 1, c + 1, c + row, c + layer};
    int meets = 0;

    for (int e = 0; e < 6; e++)
        meets |= mark[beside[e]] != 0 && mark[beside[e]] != mark[c];
    return meets;
}

/* 1 if cell c, which is amid others, is between two that have marks. */
static inline int box_is_between(const struct box *b, const int *mark, int c)
{
    const int row = b->n[0], layer = row * b->n[1];

    return (mark[c - 1] != 0 && mark[c + 1] != 0) ||
           (mark[c - row] != 0 && mark[c + row] != 0) ||
           (mark[c - layer] != 0 && mark[c + layer] != 0);
}

/* What is done in cell c, whose centre is at r [m] from that of body i and at
 * the distance s [m] from its surface. */
typedef void body_cells_act(void *by, int i, int c, const double r[3],
                            double s);

/* In each cell with a part in the body's box, and one layer more, that is not
 * farther than `reach` [m] from the surface, outside; of one that is farther
 * from it inside, s is only said to be no more than -reach. */
void body_cells_each(const struct solid_bodies *b, const struct mesh *m, int i,
                     double reach, body_cells_act *act, void *by);

#endif
