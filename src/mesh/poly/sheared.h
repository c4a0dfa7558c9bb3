/* sheared.h -- a sheared box as a mesh of any cells.  Chapter "The mesh". */
#ifndef MESH_POLY_SHEARED_H
#define MESH_POLY_SHEARED_H

#include "mesh/mesh.h"

/* The box of the specification, sheared: x grows by shear[0] y + shear[1] z, y
 * by shear[2] z. NULL after a message if its cells are too distorted. */
struct mesh *mesh_create_sheared(const struct box_spec *spec,
                                 const double shear[3]);

#endif
