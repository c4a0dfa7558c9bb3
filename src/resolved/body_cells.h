/* body_cells.h -- the cells in and around a body.
 * Chapter "Resolving the grains". */
#ifndef RESOLVED_BODY_CELLS_H
#define RESOLVED_BODY_CELLS_H

#include "mesh/mesh.h"
#include "resolved/solid_bodies.h"

/* The cells of a box around a point.
 *
 * The mesh is a box of equal cells. In a periodic direction the indices go on
 * beyond its ends.
 */

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

/* What is done in cell c, whose centre is at r [m] from that of body i and at
 * the distance s [m] from its surface. */
typedef void body_cells_act(void *by, int i, int c, const double r[3],
                            double s);

/* In each cell with a part in the body's box, and one layer more. */
void body_cells_each(const struct solid_bodies *b, const struct mesh *m, int i,
                     body_cells_act *act, void *by);

#endif
