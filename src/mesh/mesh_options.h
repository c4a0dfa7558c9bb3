/* mesh_options.h -- the mesh that a case asks for: a box and its cells, a
 * sheared box, or a mesh from files. */
#ifndef MESH_MESH_OPTIONS_H
#define MESH_MESH_OPTIONS_H

#include "base/key.h"
#include "mesh/mesh.h"

struct mesh_options {
    struct box_spec box; /* its size and cells are 0 where they are left out */
    double shear[3];     /* [-] of the box along x over y, x over z, y over z */
    const char *polymesh; /* the folder of a mesh from files; NULL: a box */
    int has_grading, has_periodic, has_shear; /* [-] 1: the case has the key */
};

extern const struct key mesh_keys[];

#endif
