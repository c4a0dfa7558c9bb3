/* body_cells.h -- the cells in and around a body.
 * Chapter "Resolving the grains". */
#ifndef RESOLVED_BODY_CELLS_H
#define RESOLVED_BODY_CELLS_H

#include "resolved/solid_bodies.h"

/* What is done in cell c, whose centre is at r [m] from that of body i and at
 * the distance s [m] from its surface. */
typedef void body_cells_act(void *by, int i, int c, const double r[3],
                            double s);

/* In each cell with a part in the body's box, and one layer more. */
void body_cells_each(const struct solid_bodies *b, const struct mesh *m, int i,
                     body_cells_act *act, void *by);

#endif
