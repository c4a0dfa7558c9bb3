/* SPDX-License-Identifier: GPL-3.0-or-later */
/* mesh_keys.c -- the keys of the group `mesh`, and the members of struct
 * mesh_options that they fill. */
#include "mesh/mesh_options.h"

#define AT(member) .at = KEY_AT(mesh_options, member)

const struct key mesh_keys[] = {
    {"mesh", KEY_GROUP, "", "", NULL,
     "a box and its cells, or a mesh from files", "", ""},
    {"mesh.size", KEY_VECTOR, "m", "> 0", "",
     "length of the box in x, y, z; y points upward; needed by a box",
     "SX15 Table 1", "", AT(box.size)},
    {"mesh.cells", KEY_COUNTS, "-", ">= 1", "",
     "cells in x, y, z; 1 where the flow does not vary; needed by a box",
     "SX15 Table 2", "", AT(box.cells), .mark = KEY_AFTER_BED},
    {"mesh.grading", KEY_VECTOR, "-", "> 0", "[1.0, 1.0, 1.0]",
     "width of the last cell over that of the first", "", "", AT(box.grading),
     .given = KEY_AT(mesh_options, has_grading)},
    {"mesh.periodic", KEY_FLAGS, "", "", "[false, false, false]",
     "periodic directions", "", "", AT(box.periodic),
     .given = KEY_AT(mesh_options, has_periodic)},
    {"mesh.polymesh", KEY_FILE, "", "", "",
     "instead of a box: the folder of an OpenFOAM mesh, beside the case unless "
     "it begins with /; its patches take the place of the sides under fluid",
     "", "", AT(polymesh)},
    {"mesh.shear", KEY_VECTOR, "-", "", "",
     "shift of the box along x over height y, along x over depth z, along y "
     "over depth z; left out: none",
     "", "", AT(shear), .given = KEY_AT(mesh_options, has_shear)},
    KEY_END};
