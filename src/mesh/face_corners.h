/* face_corners.h -- the corners of boundary faces, of any mesh. */
#ifndef MESH_FACE_CORNERS_H
#define MESH_FACE_CORNERS_H

#include "mesh/mesh.h"

/* Copies the corners [m] of boundary face f, in turn, to x, at most `most`, and
 * returns how many it has. They go round with the normal out of the mesh. */
int face_corners(const struct mesh *m, int f, int most, double (*x)[3]);

/* The middle of any boundary face [m]. */
void face_corners_middle(const struct mesh *m, int f, double x[3]);

#endif
