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

/* The cell beside cell c on this side: 2 k the lower, 2 k + 1 the upper one of
 * direction k. Negative where the box ends. */
static inline int box_beside(const struct box *b, int c, int side)
{
    const int k = side / 2, n = b->n[k];
    const int way = k > 0 ? b->n[0] * (k > 1 ? b->n[1] : 1) : 1;
    const int at = c / way % n, up = side % 2;

    if (up ? at < n - 1 : at > 0) return up ? c + way : c - way;
    return b->periodic[k] && n > 1 ? c + (up ? 1 - n : n - 1) * way : -1;
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

/* 1 if one of the cells beside cell c has a mark that is neither 0 nor the
 * same, or the box ends there; amid: c is amid others. */
static inline int box_meets_other(const struct box *b, int amid,
                                  const int *mark, int c)
{
    const int row = b->n[0], layer = row * b->n[1];
    const int beside[] = {c - 1, c + 1, c - row, c + row, c - layer, c + layer};
    int meets = 0;

    for (int e = 0; e < 6; e++) {
        const int at = amid ? beside[e] : box_beside(b, c, e);
        meets |= at < 0 || (mark[at] != 0 && mark[at] != mark[c]);
    }
    return meets;
}

/* 1 if cell c is between two that have marks, or one and an end of the box. */
static inline int box_is_between(const struct box *b, int amid, const int *mark,
                                 int c)
{
    const int way[] = {1, b->n[0], b->n[0] * b->n[1]};
    int is = 0;

    for (int k = 0; k < 3; k++) {
        const int low = amid ? c - way[k] : box_beside(b, c, 2 * k);
        const int up = amid ? c + way[k] : box_beside(b, c, 2 * k + 1);
        is |= (low < 0 || mark[low] != 0) && (up < 0 || mark[up] != 0);
    }
    return is;
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
