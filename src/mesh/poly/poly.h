/* poly.h -- meshes of OpenFOAM: points, faces, owner, neighbour, boundary.
 *
 * Chapter "The mesh".
 */
#ifndef MESH_POLY_POLY_H
#define MESH_POLY_POLY_H

#include "mesh/mesh.h"

/* The mesh of the five files in dir, or in dir/polyMesh or
 * dir/constant/polyMesh, ascii or binary, packed by gzip or not; NULL after
 * one message on stderr. Cells and faces are renumbered (poly_order.h);
 * boundary faces stay in their patch. */
struct mesh *poly_read(const char *dir);

enum { POLY_FOLDER = 960 };
/* Finds the folder of the five files; 0 and dir itself if there is none. */
int poly_folder(const char *dir, char folder[POLY_FOLDER]);
/* 1 if such a folder exists; it is looked for where POLY_LOOKED_FOR says. */
#define POLY_LOOKED_FOR                                                        \
    "no file boundary in it, in polyMesh or in constant/polyMesh"
int poly_is(const char *dir);

struct mesh_patch_name {
    char name[64];
};

/* Reads only the names of the patches that are not cyclic. Returns their number
 * and a list that the caller frees; -1 after one message. */
int poly_patches(const char *dir, struct mesh_patch_name **list);

#endif
