/* SPDX-License-Identifier: GPL-3.0-or-later */
/* boxes.h -- for tests: a mesh of equal cells, x by y by z [m]. */
#ifndef BOXES_H
#define BOXES_H

#include "mesh/mesh.h"

static inline struct mesh *closed_box(double x, double y, double z, int nx,
                                      int ny, int nz)
{
    const struct box_spec spec = {
        {x, y, z}, {nx, ny, nz}, {1.0, 1.0, 1.0}, {0, 0, 0}};

    return mesh_create_box(&spec);
}

static inline struct mesh *periodic_box(double x, double y, double z, int nx,
                                        int ny, int nz)
{
    const struct box_spec spec = {
        {x, y, z}, {nx, ny, nz}, {1.0, 1.0, 1.0}, {1, 1, 1}};

    return mesh_create_box(&spec);
}

#endif
