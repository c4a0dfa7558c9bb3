/* locate.h -- the search for the cell of a point in a polyhedral mesh.
 * Chapter "The mesh".
 */
#ifndef MESH_POLY_LOCATE_H
#define MESH_POLY_LOCATE_H

#include "mesh/mesh.h"

/* Creates m->search; everything else of the mesh must be set. No corner is
 * farther from the plane of its face than slack [m]. */
void locate_create(struct mesh *m, double slack);

/* The cell that contains x [m], or -1 outside, by a walk from cell to cell that
 * begins in the cell `begin`: each step crosses the face that the point is
 * farthest beyond, until the point is beyond none. If the walk fails (around a
 * hole, or out of a concave region), or begin is -1, all cells of the point's
 * bin are tested. offset [m] becomes the vector from the centre of the cell to
 * the point; it is not set outside. */
int locate_from(const struct mesh *m, int begin, const double x[3],
                double offset[3]);

#endif
