/* cell_window.h -- the cells of a box around a point.
 * Chapter "Resolving the grains".
 *
 * The mesh is a box of equal cells. In a periodic direction the indices go on
 * beyond its ends.
 */
#ifndef RESOLVED_CELL_WINDOW_H
#define RESOLVED_CELL_WINDOW_H

#include "mesh/mesh.h"

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

#endif
