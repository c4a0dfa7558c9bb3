/* poly.h -- meshes of OpenFOAM: points, faces, owner, neighbour, boundary.
 * Chapter 4.
 */
#ifndef POLY_H
#define POLY_H

#include "mesh/mesh.h"

/* The mesh of the five files in dir, or in dir/polyMesh or
 * dir/constant/polyMesh, written as ascii, packed by gzip or not; NULL after
 * one message on stderr. Cells and faces are put in order (poly_order.h);
 * boundary faces stay in their patch. */
struct mesh *poly_read(const char *dir);

enum { POLY_FOLDER = 960 };
/* Where the five files are; 0 and dir itself if they are nowhere. */
int poly_folder(const char *dir, char folder[POLY_FOLDER]);
/* 1 if they are somewhere. */
int poly_is(const char *dir);

/* Only the names of the patches that are not cyclic: their number, and a list
 * that is the caller's; -1 after one message. */
struct poly_patch {
    char name[64];
};
int poly_patches(const char *dir, struct poly_patch **list);

#endif
