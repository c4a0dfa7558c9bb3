/* face_corners.h -- the corners of boundary faces, of any mesh. */
#ifndef MESH_GEOMETRY_FACE_CORNERS_H
#define MESH_GEOMETRY_FACE_CORNERS_H

#include "mesh/mesh.h"

/* Copies the corners of boundary face f to x [m], at most `max` of them, and
 * returns how many the face has. Their order is counterclockwise, seen from
 * outside. */
int face_corners(const struct mesh *m, int f, int max, double (*x)[3]);

/* x = the centre of boundary face f [m]. */
void face_corners_middle(const struct mesh *m, int f, double x[3]);

#endif
