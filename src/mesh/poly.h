/* poly.h -- meshes of OpenFOAM: points, faces, owner, neighbour, boundary.
 * Chapter 4.
 */
#ifndef POLY_H
#define POLY_H

#include "mesh/mesh.h"

/* The mesh of the five files in dir (constant/polyMesh of a case), written as
 * ascii; NULL after one message on stderr. Cells and inner faces are numbered
 * anew; boundary faces keep their order within their patch. */
struct mesh *poly_read(const char *dir);

#endif
